surface half(varying float value = 0; varying color tint = 0; output varying float both = 0; output varying float seen = 0;) {
  seen = value;
  Ci = tint;
  both += 1;
}
