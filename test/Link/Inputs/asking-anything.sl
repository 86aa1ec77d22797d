// A volume that asks the surface for whatever its user says.
volume asking_anything(string name = "Kr") {
  float mine = 0;
  surface(name, mine);
  Ci *= 1 - mine;
}
