surface unstable(
  output varying float good = 0;
  output varying float large = 0;
  output varying float chosen = 0;
  output varying float given = 0;)
{
  good = sqrt(s + t + 1);
  float huge = 3e38;
  large = (huge * (1 + s)) - huge * s;
  float third = s / 3;
  chosen = (third * 3 == s) ? 1 : 0;
  given = 1 + comp(Cs, 0);
  Ci = good;
}
