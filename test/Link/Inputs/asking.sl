// A volume that asks the surface for a parameter of it.
volume asking() {
  float mine = 0;
  surface("Kr", mine);
  Ci *= 1 - mine;
}
