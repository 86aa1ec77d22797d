#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_kinks(CASE varying float x = 0, y = 0; output varying float ofAbs = 0, ofMin = 0, ofMax = 0, ofClamp = 0, ofStep = 0, ofFloor = 0, ofMod = 0;) {
  IF_ACTIVE {
    float a = x + u;
    ofAbs = Du(abs(a));
    ofMin = Du(min(a, y));
    ofMax = Du(max(a, y));
    ofClamp = Du(clamp(a, 0, y));
    ofStep = Du(step(y, a)) + Du(ceil(a));
    ofFloor = Du(floor(a));
    ofMod = Du(mod(a, y));
  }
}
