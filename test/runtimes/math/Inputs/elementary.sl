/* Every elementary function, over ranges that reach into the hard ones. */
surface elementary()
{
  float a = 40*s - 20, b = 12*t + 0.01;
  Ci = color(sin(a) + cos(a*100000) + exp(a) + tan(a),
             log(b) + pow(b, a/4) + atan(a, b) + atan(a*b) + log(b, 10),
             acos(t) + asin(s) + sqrt(b) + inversesqrt(b) + exp(a*6) + sin(pow(b, 30)));
}
