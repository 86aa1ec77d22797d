#include "waves.h"
displacement waves() {
  WAVES
  P += (r - 2) * normalize(P - point "object" (0, 0, 0));
  N = calculatenormal(P);
}
