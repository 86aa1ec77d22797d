/* Derivatives that nobody reads cost nothing, through loops, branches and arrays, and only those inputs are asked for
   whose derivatives somebody reads.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so --report %t.json
RUN: FileCheck %s < %t.json
RUN: anysl-link %t.stc.bc --real double --runtime scalar --width 1 -o %t.double.so --report %t.double.json
RUN: FileCheck %s --check-prefix DOUBLE < %t.double.json
RUN: rslc -DFILTER=step %s -o %t.step.stc.bc
RUN: anysl-link %t.step.stc.bc --width 1 -o %t.float.so --report %t.float.json
RUN: FileCheck %s --check-prefix FLOAT < %t.float.json
RUN: anysl-link %t.step.stc.bc --real dual --width 1 -o %t.dual.so --report %t.dual.json
RUN: FileCheck %s --check-prefix DUAL < %t.dual.json

The plain code and that of numbers whose derivatives nobody reads have about as many instructions, those of one
filterstep a hundred more.
RUN: python3 -c "import json, sys; n = [json.load(open(f))['shaders'][0]['scalarInstructions'] for f in sys.argv[1:]]; print(n); sys.exit(n[1] > 1.01 * n[0] or n[2] > n[0] + 100)" %t.float.json %t.dual.json %t.json

CHECK: "real": "dual"
CHECK: "Derivatives"
CHECK: "globalsRead": [
CHECK-DAG: "s"
CHECK-DAG: "du"
CHECK-DAG: "dsdu"
CHECK-DAG: "dsdv"
CHECK-NOT: dNd
CHECK-NOT: dPd
CHECK-NOT: dtd
CHECK: "globalsWritten"

DOUBLE: "real": "dualdouble"

FLOAT: "real": "float"
DUAL: "real": "dual"
DUAL: "globalsRead": [
DUAL-NOT: "d
DUAL: "globalsWritten"
*/

#ifndef FILTER
#define FILTER filterstep
#endif

float turbulence(point p) {
  float i, sum = 0, frequency = 1;
  for (i = 0; i < 4; i += 1) {
    sum += abs(float noise(p * frequency) - 0.5) / frequency;
    frequency *= 2;
  }
  return sum;
}

surface shader(float Kd = 0.8; color base = (0.5, 0.2, 0.1);) {
  normal Nf = faceforward(normalize(N), I);
  float waves[4], i;
  vector places[3] = {P, P, N};
  for (i = 0; i < 4; i += 1) {
    waves[i] = sin(i * t);
    places[i - 1] = P * i;
  }
  color c = base * turbulence(P + places[3 * t]) + waves[4 * t] * Cs;
  if (c[0] > 0.3)
    c *= sqrt(t);
  else
    c += smoothstep(0, 1, s);
  float x = 0.1 + t;
  while (x < 3)
    x *= 2;
  Ci = c * Kd * diffuse(Nf) * x;
  Oi = FILTER(0.5, s);
}
