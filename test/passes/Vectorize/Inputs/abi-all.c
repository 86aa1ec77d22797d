#include "abi-all.h"

LOAD_SCALE;
MIXED;
WIDE_RESULT;
ITERATIONS;
BYTES;
LONGS;
STORE_SCALED;

#pragma omp declare simd uniform(w) linear(i) simdlen(8) notinbranch
void work_all(struct Work *w, int i) {
  w->fo[i] = load_scale(w->p, i, w->x[i]);
  w->d1[i] = mixed(w->x[i], w->y[i], w->n[i]);
  w->d2[i] = wide_result(w->y[i]);
  w->io[i] = iterations(w->n[i]);
  w->bo[i] = bytes(w->b[i], w->n[i]);
  w->lo[i] = longs(w->s[i], w->l[i]);
  store_scaled(&w->stored[i], 3, w->x[i]);
}

#pragma omp declare simd uniform(w) linear(i) simdlen(8) notinbranch
void work_some(struct Work *w, int i) {
  if (w->n[i] & 1) {
    w->fo[i] = load_scale(w->p, i, w->x[i]);
    w->d1[i] = mixed(w->x[i], w->y[i], w->n[i]);
    store_scaled(&w->stored[i], 3, w->x[i]);
  } else {
    w->d2[i] = wide_result(w->y[i]);
    w->io[i] = iterations(w->n[i]);
  }
  if (w->s[i] > 0) {
    w->bo[i] = bytes(w->b[i], w->n[i]);
    w->lo[i] = longs(w->s[i], w->l[i]);
  }
}
