/* One item of work that calls every function of abi.h, always or within branches. */
#include "abi.h"

enum { N = 256 };
struct Work {
  float p[N], x[N], fo[N], stored[N];
  double y[N], d1[N], d2[N];
  int n[N], io[N];
  signed char b[N], bo[N];
  short s[N];
  long long l[N], lo[N];
};

#pragma omp declare simd uniform(w) linear(i) simdlen(8) notinbranch
void work_all(struct Work *w, int i);
#pragma omp declare simd uniform(w) linear(i) simdlen(8) notinbranch
void work_some(struct Work *w, int i);
