// The normal and the derivatives of the waves, which the sphere has, beside their closed forms.
#include "waves.h"
surface moved() {
  WAVES
  vector n = normalize(N), found = calculatenormal(P);
  Ci = 0.5 + color(max(min(length(n - exact), length(n + exact)), min(length(found - exact), length(found + exact))),
                   length(dPdu - byU) / 12, length(dPdv - byV) / 6);
}
