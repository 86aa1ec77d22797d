/* s and t are multiples of 1/16 on a grid of 17 x 17, so that no sum or product here is rounded. */
surface anchors() {
  float zero = sin(0 * s) + exp(0 * t) - 1 + log(1 + 0 * s);
  Ci = color(pow(s, 2), pow(t, 1), zero + pow(s + 1, 0));
  Oi = cos(0 * t);
}
