// RUN: rslc -verify -fsyntax-only %s

float sum(float list[]) {
  float total = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    total += list[i];
  return total;
}
float three(float list[3]) { return list[0]; }          // expected-note 2 {{candidate: float three(float[3])}}

void grow(output float list[]) { push(list, 1); }        // expected-note {{declared here}}

surface arrays(float n = 3; float given[2] = {1, 2}; float open[] = {1, 2, 3}) {
  float a[2 * 3 - 1] = {1, 2, 3, 4, 5};
  float b[n], b2[];                 // resizable
  float c[0];                       // expected-error {{the length of an array must be an integer from 1 to 65536}}
  float d[2.5];                     // expected-error {{the length of an array must be an integer}}
  float e[2] = {1, 2, 3};           // expected-error {{3 values for an array of 2}}
  float f[] = {1, 2};
  float g["a"];                     // expected-error {{the length of an array must be a constant number}}
  resize(a, 2);                     // expected-error {{the length of array 'a' is fixed; one declared with [] can change its}} expected-note@-7 {{declared here}}
  grow(d);                          // expected-error {{'grow' changes the length of its parameter 'list', and that of this array is fixed}}
  grow(f);
  push(b, "x");                     // expected-error {{argument 2 of 'push': a value of type 'string' is no 'float'}}
  push(b);                          // expected-error {{'push' takes an array and a value}}
  pop(n);                           // expected-error {{'pop' needs an array, not a 'float'}}
  uniform float u[];                // expected-note {{declared here}}
  push(u, s);                       // expected-error {{a varying value cannot be assigned to uniform 'u'}}
  b2[1] = 0;                        // expected-error {{index outside of the array's capacity, which is so far 1; reserve(…) raises it}}
  reserve(b2, 100);
  b2[99] = capacity(b2);
  color h[2] = {1, (1, 2, 3)};
  float x = a[5];                   // expected-error {{index outside of the array, which has 5 elements}}
  a = given;                        // expected-error {{a value of type 'float[2]' is no 'float[5]'}}
  a[0] = a;                         // expected-error {{a value of type 'float[5]' is no 'float'}}
  x = a + 1;                        // expected-error {{'+' does not take 'float[5]' and 'float'}}
  x = {1, 2};                       // expected-error {{is only the value of an array}}
  x = sum(a) + sum(f) + three(open) + arraylength(h);
  x = three(a);                     // expected-error {{no function 'three' takes (float[5])}}
  x = three(1);                     // expected-error {{no function 'three' takes (float)}}
}
