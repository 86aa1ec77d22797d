// Light shaders for sent-to-lights.sl, which a surface tells what to do.
light told(float level = 1; color tint = (1, 2, 3); point from = (0, 0, 2); string mode = "plain";
           float weights[3] = {1, 0, 0}; matrix m = 1; float twice = level * 2; string __category = "told";
           output varying float heard = 0; output varying color both[2] = {0, 0};) {
  illuminate (from) {
    Cl = level * tint * (mode == "tenfold" ? 10 : 1) * (weights[0] + 2 * weights[1] + 4 * weights[2]) * comp(m, 0, 0);
    heard = level + 100 * twice;
    both[0] = tint;
    both[1] = level;
  }
}

light deaf(string __category = "deaf") {
  solar (vector (0, 0, -1), 0)
    Cl = 1;
}
