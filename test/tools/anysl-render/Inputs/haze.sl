/* A volume that shows what it learns about the surface behind it: a parameter, and what that computed. */
volume haze() {
  float Kd = 9;
  color marked = 9;
  string name = "none";
  surface("Kd", Kd);
  surface("marked", marked);
  printf("haze over %s\n", shadername("surface"));
  Ci = color (comp(marked, 1), Kd, comp(marked, 2));
}
