/* Half of each colour is lit, half is noise that more samples make better. */
surface flat(float Ka = 1, samples = 1) {
  float i, sum = 0;
  for (i = 0; i < samples; i += 1)
    sum += random();
  Ci = Cs * (Ka * ambient() + diffuse(faceforward(normalize(N), I))) + 0.1 * sin(20 * xcomp(P)) + sum / samples;
}
