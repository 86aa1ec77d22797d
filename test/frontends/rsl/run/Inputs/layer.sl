// A shader for others to call: run/coshaders.sl.
struct Geo { varying point P = 0; varying normal Nn = 0; float kd = 1; }

class layer(float gain = 2; color tint = (1, 2, 3); string __category = "paint"; output varying float unused = 0) {
  varying float seen = 0;
  public void begin() { seen = s; }
  public color shade(color base; float amount) { return base * tint * amount * gain; }
  public float bump(point at; normal n) { return zcomp(at) + seen * 10 + zcomp(n) * 100; }
  public void move(output point at; float by; output float count) { at += by; count += 1; }
  public constant string type = "layer";
  public constant float scale = 4;
  public float lit(Geo g; output Geo back) { back = g; back->kd = g->kd * scale; return zcomp(g->Nn); }
  public matrix turned(matrix m) { return 2 * m; }
  public void surface(output color Ci, Oi) { Ci = tint * this->double(seen); Oi = 0.5; }
  float double(float x) { return 2 * x; }
  public string name() { return "layer"; }     // text cannot be handed over: this is for layer alone
}
