// The normal of the waves, where the sphere has none, beside its closed form. All is 0.5 where all is right.
#include "waves.h"
surface bumped() {
  WAVES
  vector found = calculatenormal(P + (r - 2) * normalize(P - point "object" (0, 0, 0)));
  Ci = 0.5 + color(min(length(found - exact), length(found + exact)));
}
