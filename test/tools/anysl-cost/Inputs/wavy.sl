/* Elementary functions on several lines, with arguments of many sizes. */
surface wavy(float scale = 9) {
  float wave = sin(scale * s) * cos(scale * t);
  float glow = exp(-3 * abs(wave));
  float bright = pow(glow, 0.7);
  Ci = color(glow, bright, 0.5 + 0.5 * wave);
  Oi = 1;
}
