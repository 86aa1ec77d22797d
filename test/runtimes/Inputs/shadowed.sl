// Lights for traced-lookups.sl, which find their own shadows.
light above(string shadowname = ""; point from = (0, 0, 2); string __category = "above") {
  illuminate (from)
    Cl = 1 - shadow(shadowname, Ps);
}
light below(string shadowname = ""; point from = (0, 0, -3); string __category = "below") {
  illuminate (from)
    Cl = 1 - shadow(shadowname, Ps, "samples", 4, "bias", 0.1);
}
light sun(string shadowname = ""; vector direction = (0, 0, -1); string __category = "sun") {
  solar (direction, 0)
    Cl = 1 - shadow(shadowname, Ps, Ps, Ps, Ps);
}
light moon(vector direction = (0, 0, 1); string __category = "moon") {
  solar (direction, 0)
    Cl = 1 - shadow("raytrace", Ps);
}
light reflected(string map = "raytrace"; string __category = "reflected") {
  solar (vector (0, 0, -1), 0)
    Cl = environment(map, vector (1, 0, 1));
}
