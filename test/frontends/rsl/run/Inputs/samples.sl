// What array-results.sl calls.
struct Sample { varying vector dir = 0; varying float pdf = 0; float w[2] = {0, 0}; string tag = ""; }
class lib(float gain = 2; float table[3] = {5, 6, 7}) {
  public float[3] scaled(float x) { float a[3] = {1, 2, 3}; a[0] = x; a[1] *= gain; return a; }
  public float[] upto(float n) { float a[]; float i; for (i = 0; i < n; i += 1) push(a, i * gain); return a; }
  public Sample draw(float x) { Sample s; s->dir = vector (x, 2, 3); s->pdf = gain; s->w[0] = 8; s->w[1] = 9; s->tag = "lib"; return s; }
  public string[2] names() { return {"a", concat("b", "c")}; }
  public void surface(output color Ci, Oi) { Ci = 1; }
}
