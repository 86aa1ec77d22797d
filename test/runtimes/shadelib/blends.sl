// TESTS: clamp_float clamp_color clamp_vector mix_float mix_color mix_vector
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x2
// EXPECT clamped: 1 0.5 3 3
// EXPECT clampedColor: 0 0.5 1
// EXPECT clampedVector: 0 0.5 1
// EXPECT mixed: 2.5 2 4
// EXPECT mixedColor: 0.25 1 1.75
// EXPECT mixedVector: 0.25 1 1.75
surface blends(float one = 1; output varying float clamped[4] = {9, 9, 9, 9}; output varying color clampedColor = 9;
               output varying vector clampedVector = 9; output varying float mixed[3] = {9, 9, 9}; output varying color mixedColor = 9;
               output varying vector mixedVector = 9;) {
  clamped[0] = clamp(5, 3, one); // a low limit above the high one: the high one
  clamped[1] = clamp(0.5, 0, one);
  clamped[2] = clamp(-7, 3 * one, 5);
  clamped[3] = clamp(0, 3 * one, 1); // below a low limit above the high one: the low one
  clampedColor = clamp(color (-one, 0.5, 2), color 0, color 1);
  clampedVector = clamp(vector (-one, 0.5, 2), vector 0, vector 1);
  mixed[0] = mix(2, 4, 0.25 * one);
  mixed[1] = mix(2, 4, 0 * one);
  mixed[2] = mix(2, 4, one);
  mixedColor = mix(color (0, 1, 2), color (1, 1, 1), 0.25 * one);
  mixedVector = mix(vector (0, 1, 2), vector (1, 1, 1), 0.25 * one);
}
