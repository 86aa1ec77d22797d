// A surface with an effect for each of the things that a scene may do without.
surface effects(float Kd = 1, Kr = 0; string tex = ""; output varying color mirrored = 0; output varying float dots = 0) {
  normal Nf = faceforward(normalize(N), I);
  color c = Cs * Kd * diffuse(Nf);
  if (Kr > 0)
    c += Kr * trace(P, reflect(I, Nf));
  if (tex != "")
    c *= texture(tex);
  mirrored = environment("sky.tex", reflect(I, Nf));
  dots = noise(10 * P);
  Oi = Os;
  Ci = Os * c;
}
