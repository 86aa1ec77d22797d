// TESTS: distance faceforward reflect rotate ptlined
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x2
// EXPECT between: 13
// EXPECT faced: 0 0 1
// EXPECT turnedAway: 0 0 -1
// EXPECT grazing: 0 0 1
// EXPECT reflected: 0.6 0 0.8
// EXPECT turned: 2 0 5
// EXPECT unturned: 1 2 3
// EXPECT lines: 2 5 0
surface geometry(float one = 1; output varying float between = 9; output varying vector faced = 9; output varying vector turnedAway = 9;
                 output varying vector grazing = 9; output varying vector reflected = 9; output varying point turned = 9;
                 output varying point unturned = 9; output varying float lines[3] = {9, 9, 9};) {
  between = distance(point (1, 2, 3), point (4 * one, 6, 15));
  vector up = vector (0, 0, one);
  faced = faceforward(up, vector (1, 0, -1), up);
  turnedAway = faceforward(up, vector (0.1, 0, 0.01), up);
  grazing = faceforward(up, vector (1, 0, 0), up); // neither side: N as it is, never nothing
  reflected = reflect(vector (0.6, 0, -0.8), up);
  // A quarter turn about the axis through (1, 0, 0) and (1, 0, 5), whatever its length.
  turned = rotate(point (1, -1, 5), PI / 2 * one, point (1, 0, 0), point (1, 0, 5 * one));
  unturned = rotate(point (1, 2, 3), one, point (4, 5, 6), point (4, 5, 6));
  lines[0] = ptlined(point (0, 0, 0), point (5 * one, 0, 0), point (1, 2, 0));
  lines[1] = ptlined(point (0, 0, 0), point (5 * one, 0, 0), point (8, 4, 0)); // past the end
  lines[2] = ptlined(point (1, 2, 3), point (1 * one, 2, 3), point (1, 2, 3)); // no segment, a point
}
