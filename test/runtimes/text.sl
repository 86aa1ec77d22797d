// Text made while shading is the same at every width and compares by its characters, also in branches that only some
// points take.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x3 --param base=wood
// EXPECT same: 1 1 1 1 1 1 1 1
// EXPECT found: 1 0 1 1 0 0 1
// EXPECT values: 1 1 1 1 1 1
string numbered(string base; float frame) { return format("%s.%04d.tex", base, frame); }

surface text(string base = ""; string made = concat(base, "/", format("%g", 0.25));
             output varying float same[8] = {0, 0, 0, 0, 0, 0, 0, 0}, found[7] = {1, 1, 1, 1, 1, 1, 1}, values[6] = {0, 0, 0, 0, 0, 0};) {
  same[0] = numbered(base, 7) == "wood.0007.tex";
  same[1] = made == "wood/0.25";
  same[2] = concat(base, "en", "") != "wood" && concat(base) == "wood" && concat("", "") == "";
  same[3] = shadername() == "text";

  // Different for each column of the grid.
  float column = floor(s * 8 + 0.5);
  string varied = numbered(base, column);
  float i;
  for (i = 0; i < 9; i += 1)
    if (i == column && varied == format("%s.000%d.tex", "wood", i))
      same[4] = 1;
  string side = "left";
  if (column > 4)
    side = format("right %g", column);
  else if (column == 4)
    side = concat(base, " middle");
  if (column > 4)
    same[5] = side == format("right %d", column);
  else
    same[5] = column == 4 ? side == "wood middle" : side == "left";
  if (column > 2 && column < 5)
    same[6] = match("^wood.000[34].tex$", varied);
  else
    same[6] = 1 - match("000[34]", varied);
  string pattern = format("00%g\\.", column);
  same[7] = match(pattern, varied);

  found[0] = match("o\+", base);
  found[1] = match("^oo", base);
  found[2] = match("\(x\|w\)oo", base);
  found[3] = match("^wo\?o*d$", base);
  found[4] = match("[", base);
  found[5] = match("\(", base);
  found[6] = match("", base);

  values[0] = format("%5.2f|%-5.1f|%e", 0.25, 2, 1000) == " 0.25|2.0  |1.000000e+03";
  values[1] = format("%p", vector (1, -2, 0.5)) == "1.000000 -2.000000 0.500000";
  values[2] = format("%.1c%%", color (0.5, 1, 0)) == "0.5 1.0 0.0%";
  values[3] = format("%.0m", matrix (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)) ==
              "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16";
  string later = "%s and %g";
  values[4] = format(later, base, 1) == "wood and 1";
  if (column > 3)
    later = "%s or %g";
  values[5] = format(later, base, 1) == (column > 3 ? "wood or 1" : "wood and 1");
}
