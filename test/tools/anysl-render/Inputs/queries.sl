/* What a surface finds out by name. */
surface queries(string side = ""; float Kd = 0.5; output varying color marked = 0;) {
  string wood = "none", renderer = "none", type = "none";
  float weight = 9, format[3], clipping[2], depth = 9, quality = 9, absent = 0;
  attribute("user:wood", wood);
  attribute("user:weight", weight);
  option("Format", format);
  option("Clipping", clipping);
  option("user:quality", quality);
  rendererinfo("renderer", renderer);
  rayinfo("depth", depth);
  rayinfo("type", type);
  absent = attribute("user:absent", absent) + option("user:weight", absent) + displacement("Kd", absent);
  if (depth == 0 && type == "camera" && absent == 0 && clipping[0] == 1)
    printf("%s %s %g %g %g %s\n", side, wood, format[0], format[1], quality, renderer);
  marked = color (0, weight, 1);
  Ci = weight;
  Oi = 1;
}
