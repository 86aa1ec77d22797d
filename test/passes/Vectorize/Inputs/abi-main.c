/* Compares the widened work with the scalar one. A variant without vector arguments can be called by its
   name; the instruction set comes from the command line, -DVARIANT_OF=_ZGVdN8ul. */
#include "abi-all.h"
#include <stdio.h>
#include <string.h>

#define JOIN(a, b) a##_##b
#define VARIANT(prefix, name) JOIN(prefix, name)
void VARIANT(VARIANT_OF, work_all)(struct Work *, int);
void VARIANT(VARIANT_OF, work_some)(struct Work *, int);

static struct Work wide, scalar;
static void (*volatile all)(struct Work *, int) = work_all;
static void (*volatile some)(struct Work *, int) = work_some;

static void fill(struct Work *w) {
  unsigned seed = 1;
  memset(w, 0, sizeof *w);
  for (int i = 0; i < N; ++i) {
    seed = seed * 1664525 + 1013904223;
    w->p[i] = (int)(seed >> 20) / 64.f - 20;
    w->x[i] = (int)(seed >> 12 & 255) / 64.f - 2;
    w->y[i] = (int)(seed >> 9 & 1023) / 256. - 2;
    w->n[i] = (int)(seed >> 7) - 1000;
    w->b[i] = (signed char)(seed >> 13);
    w->s[i] = (short)(seed >> 11);
    w->l[i] = (long long)seed * (int)(seed >> 3) - 12345678901ll;
  }
}

static int differ(const char *what) {
  int failures = 0;
  for (int i = 0; i < N; ++i) {
#define EXPECT(field)                                                                              \
  if (memcmp(&wide.field[i], &scalar.field[i], sizeof wide.field[i]) != 0) {                       \
    printf("%s: %s[%d] differs\n", what, #field, i);                                               \
    ++failures;                                                                                    \
  }
    EXPECT(fo) EXPECT(stored) EXPECT(d1) EXPECT(d2) EXPECT(io) EXPECT(bo) EXPECT(lo)
  }
  return failures;
}

int main(void) {
  int failures = 0;
  fill(&wide);
  fill(&scalar);
  for (int i = 0; i < N; i += 8)
    VARIANT(VARIANT_OF, work_all)(&wide, i);
  for (int i = 0; i < N; ++i)
    all(&scalar, i);
  failures += differ("all");
  fill(&wide);
  fill(&scalar);
  for (int i = 0; i < N; i += 8)
    VARIANT(VARIANT_OF, work_some)(&wide, i);
  for (int i = 0; i < N; ++i)
    some(&scalar, i);
  failures += differ("some");
  if (failures == 0)
    puts("all calls agree");
  return failures != 0;
}
