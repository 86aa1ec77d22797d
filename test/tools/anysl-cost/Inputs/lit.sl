surface lit() {
  Ci = diffuse(normalize(N));
}
