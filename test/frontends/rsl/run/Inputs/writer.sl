// Another shader that is handed texts and arrays: run/coshader-texts.sl.
class writer(string name = "writer"; float weights[3] = {1, 2, 4}; string tags[] = {}; color tints[2] = {1, (1, 2, 3)}) {
  public string greet(string who; float n) { return format("%s to %s %d", name, who, n); }
  public float dot(float a[3]; float b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  public float total(float list[]) {
    float sum = 0;
    uniform float i;
    for (i = 0; i < arraylength(list); i += 1)
      sum += list[i];
    return sum;
  }
  public void grow(output float list[]; output string words[2]) {
    push(list, 10 * arraylength(list));
    words[1] = concat(words[0], "+");
  }
  public color mean(color tints[]) {
    color sum = 0;
    uniform float i;
    for (i = 0; i < arraylength(tints); i += 1)
      sum += tints[i];
    return sum / arraylength(tints);
  }
  public void surface(output color Ci, Oi) { Ci = 1; }
}
