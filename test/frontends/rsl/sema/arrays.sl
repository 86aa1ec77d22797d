// RUN: rslc -verify -fsyntax-only %s

float sum(float list[]) {
  float total = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    total += list[i];
  return total;
}
float three(float list[3]) { return list[0]; }          // expected-note 2 {{candidate: float three(float[3])}}

surface arrays(float n = 3; float given[2] = {1, 2}; float open[] = {1, 2, 3}) {
  float a[2 * 3 - 1] = {1, 2, 3, 4, 5};
  float b[n];                       // expected-error {{the length of an array must be a constant number}}
  float c[0];                       // expected-error {{the length of an array must be an integer from 1 to 65536}}
  float d[2.5];                     // expected-error {{the length of an array must be an integer}}
  float e[2] = {1, 2, 3};           // expected-error {{3 values for an array of 2}}
  float f[] = {1, 2};
  float g[];                        // expected-error {{array 'g' needs a length}}
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
