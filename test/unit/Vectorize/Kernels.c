/*===-- test/unit/Vectorize/Kernels.c - small functions to widen, one a difficulty -------*- C -*-===*
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===*
 *
 * Compiled to bitcode with -O1 -fwrapv -ffp-contract=off; each kernel has a line in Kernels.def.
 *
 *===--------------------------------------------------------------------------------------------===*/

#include "Kernels.h"

typedef struct Args Args;
extern int anyslTestOpaque(int x, float y);

/*===-- Straight lines ------------------------------------------------------===*/

void arithmetic(Args *a, int lane) {
  float x = a->f[0][lane], y = a->f[1][lane];
  a->fo[0][lane] = x * y - x / (y + 2) + a->uniform;
  a->dout[0][lane] = a->d[0][lane] * x - a->d[1][lane];
  a->io[0][lane] = (a->i[0][lane] ^ a->i[1][lane]) + (a->i[2][lane] << 3) - lane;
  a->lo[0][lane] = a->l[0][lane] * a->i[1][lane] + (a->l[1][lane] >> 7);
  a->so[lane] = (short)(a->s[0][lane] + a->s[1][lane] * 3);
  a->bo[lane] = (unsigned char)(a->b[0][lane] - a->b[1][lane]);
}

void conversions(Args *a, int lane) {
  a->fo[0][lane] = (float)a->i[0][lane] + (float)a->l[0][lane] + (unsigned char)a->b[0][lane];
  a->dout[0][lane] = (double)a->f[0][lane] + (double)(unsigned)a->i[1][lane] + a->s[0][lane];
  float x = a->f[1][lane];
  a->io[0][lane] = x > -1000 && x < 1000 ? (int)x : -7;
  a->lo[0][lane] = (long long)a->i[0][lane] * a->s[0][lane] + (unsigned short)a->s[1][lane];
  a->so[lane] = (short)a->i[2][lane];
  a->bo[lane] = (unsigned char)a->l[2][lane];
}

void library(Args *a, int lane) {
  float x = a->f[0][lane];
  a->fo[0][lane] = __builtin_sqrtf(__builtin_fabsf(x)) + __builtin_floorf(a->f[1][lane]);
  a->fo[1][lane] = __builtin_copysignf(a->f[1][lane], x) + __builtin_truncf(a->f[2][lane]);
  a->dout[0][lane] = __builtin_fma(a->d[0][lane], a->d[1][lane], a->d[2][lane]);
  a->io[0][lane] = __builtin_popcount(a->i[0][lane]) + __builtin_clz(a->i[1][lane] | 1) +
                   __builtin_ctz(a->i[2][lane] | 256) + __builtin_abs(a->s[0][lane]);
  a->lo[0][lane] = __builtin_bswap64(a->l[0][lane]);
}

void overflow(Args *a, int lane) {
  int sum;
  if (__builtin_add_overflow(a->i[0][lane], a->i[1][lane], &sum))
    sum = 77;
  long long product;
  if (__builtin_mul_overflow(a->l[0][lane], a->l[1][lane], &product))
    product = -77;
  a->io[0][lane] = sum;
  a->lo[0][lane] = product;
}

void turnedSigns(Args *a, int lane) {
  float x = a->f[0][lane], y = a->f[1][lane];
  double z = a->d[0][lane];
  unsigned bits = a->i[0][lane];
  a->fo[0][lane] = ((bits & 1) ? -x : x) + ((bits & 64) ? y : -y);
  a->fo[1][lane] = x < y ? -x : x;
  a->dout[0][lane] = ((bits & 2) ? -z : z) * ((a->l[0][lane] & 4) ? a->d[1][lane] : -a->d[1][lane]);
}

/*===-- Branches ------------------------------------------------------------===*/

void ifElse(Args *a, int lane) {
  float x = a->f[0][lane], r;
  if (x > 0) {
    r = a->f[1][lane] / x;
    if (r > 1)
      r = __builtin_sqrtf(r) + x * x * x - r / 3 + x / 7;
    a->io[0][lane] = 1;
  } else {
    r = x * 2;
    if (a->n > 4)
      r += a->f[2][lane];
    else
      a->io[1][lane] = a->n;
  }
  a->fo[0][lane] = r;
}

void uniformIf(Args *a, int lane) {
  float x = a->f[0][lane];
  if (a->n > 6) {
    x = x * x;
    if (x > 1 && a->m > 3)
      x -= a->table[a->n];
  } else if (a->n > 2) {
    x = x + 1;
  }
  a->fo[0][lane] = x;
}

void switches(Args *a, int lane) {
  int r = a->i[0][lane];
  switch (a->i[1][lane] & 7) {
  case 0:
    r += 5;
    break;
  case 1:
    r *= 3;
    /* falls through */
  case 2:
    r -= a->i[2][lane];
    break;
  case 3:
    a->io[1][lane] = r;
    return;
  case 5:
  case 6:
    r = r > 0 ? r : -r;
    break;
  default:
    r = ~r;
  }
  a->io[0][lane] = r;
}

void earlyReturn(Args *a, int lane) {
  if (a->i[0][lane] < 0)
    return;
  a->io[0][lane] = a->i[1][lane];
  if (a->i[1][lane] < 0) {
    a->io[1][lane] = 5;
    return;
  }
  for (int k = 0; k < a->n; ++k) {
    if (a->i[2][lane] == k)
      return;
    a->io[2][lane] += k * a->i[0][lane];
  }
  a->fo[0][lane] = 3;
}

void jumpInto(Args *a, int lane) {
  /* Blocks that several branches share without nesting. */
  int x = a->i[0][lane], r = 1;
  if (x > 10) {
    r += 2;
    if (a->i[1][lane] > 0)
      goto shared;
    r *= 5;
    if (a->n > 5)
      goto other;
  } else if (x < -10) {
    r = 11;
    if (a->i[2][lane] > 0)
      goto other;
  shared:
    r = r * 7 + a->i[2][lane];
    if (a->m > 3)
      goto end;
  }
  r += x;
other:
  r ^= a->i[1][lane];
end:
  a->io[0][lane] = r;
}

/*===-- Loops ---------------------------------------------------------------===*/

void uniformLoop(Args *a, int lane) {
  float sum = 0;
  for (int k = 0; k < a->n; ++k)
    sum += a->f[0][lane] * k + a->table[k];
  a->fo[0][lane] = sum;
}

void divergentLoop(Args *a, int lane) {
  unsigned n = a->i[0][lane] & 1023, count = 0;
  while (n != 0 && count < 60) {
    n = n & 1 ? (3 * n + 1) & 4095 : n / 2;
    ++count;
    if (n == 1)
      break;
  }
  a->io[0][lane] = count;
  a->io[1][lane] = n;
}

void mandelbrot(Args *a, int lane) {
  float cx = a->f[0][lane], cy = a->f[1][lane], x = 0, y = 0;
  int k = 0;
  for (; k < 40; ++k) {
    float xx = x * x, yy = y * y;
    if (!(xx + yy <= 4))
      break;
    y = 2 * x * y + cy;
    x = xx - yy + cx;
  }
  a->io[0][lane] = k;
  a->fo[0][lane] = x;
  a->fo[1][lane] = y;
}

void nestedLoops(Args *a, int lane) {
  int total = 0, x = a->i[0][lane] & 15;
  for (int i = 0; i < x; ++i) {
    if ((a->i[1][lane] + i) % 5 == 2)
      continue;
    for (int j = i; j < a->n; ++j) {
      if ((i * j + a->i[2][lane]) % 7 == 3)
        break;
      total += i ^ j;
      if (total > 300)
        goto out;
    }
    total *= 2;
    if (a->m == i)
      break;
  }
  total -= 1000;
out:
  a->io[0][lane] = total;
}

void returnFromLoops(Args *a, int lane) {
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < a->n; ++j) {
      int t = a->itable[(i * 16 + j + (a->i[0][lane] & 7)) & 255];
      if (t > 60) {
        a->io[0][lane] = t;
        a->io[1][lane] = i * 100 + j;
        return;
      }
      if (t < -95) {
        a->io[2][lane] = i;
        break;
      }
    }
  a->io[0][lane] = -1;
}

void loopInIf(Args *a, int lane) {
  float r = 0;
  if (a->f[0][lane] > 0) {
    for (int i = 0; i < a->n; ++i)
      for (int j = 0; j < a->m; ++j)
        r += a->f[1][lane] * i - j;
    if (r > 10)
      for (int k = 0; k < a->m; ++k)
        r *= 0.5f;
  } else {
    int k = a->b[0][lane] & 15;
    do {
      r += k;
    } while (--k > 0);
  }
  a->fo[0][lane] = r;
}

/* An empty mask must not run it: the guard that keeps n above zero is false for all lanes. */
void loopWithUniformBound(Args *a, int lane) {
  int n = a->n, r = 0;
  if (a->i[0][lane] > 0 && n > 0) {
    do {
      r += a->i[1][lane] ^ n;
    } while (--n != 0);
  }
  a->io[0][lane] = r;
}

void liveOuts(Args *a, int lane) {
  int k = 0, last = -1, first = -1, limit = a->b[0][lane] & 31;
  float f = 1;
  for (;;) {
    if (k >= limit)
      break;
    int t = a->itable[(k + a->b[1][lane]) & 255];
    if (t & 1)
      last = k;
    if (first < 0 && t > 50)
      first = k;
    f = f * 0.75f + t;
    ++k;
    if (t == 33)
      break;
  }
  a->io[0][lane] = k;
  a->io[1][lane] = last;
  a->io[2][lane] = first;
  a->fo[0][lane] = f;
}

void swapInLoop(Args *a, int lane) {
  int x = a->i[0][lane], y = a->i[1][lane], n = a->b[0][lane] & 15;
  for (int k = 0; k < n; ++k) {
    int t = x;
    x = y;
    y = t + k;
  }
  a->io[0][lane] = x;
  a->io[1][lane] = y;
}

void irreducible(Args *a, int lane) {
  int x = a->i[0][lane] & 255, steps = 0, r = 0;
  if (a->i[1][lane] > 0)
    goto second;
first:
  r += 3;
  x -= 7;
  if (++steps > 30)
    goto end;
  if (x < 20)
    goto end;
second:
  r ^= x;
  x -= 11;
  if (++steps > 30 || x < 0)
    goto end;
  if (x & 4)
    goto first;
  r += 100;
  if (x & 8)
    goto second;
  if (x > 40)
    goto first;
end:
  a->io[0][lane] = r;
  a->io[1][lane] = steps * 1000 + x;
}

void stateMachine(Args *a, int lane) {
  int state = a->i[0][lane] & 3, x = a->i[1][lane] & 127, fuel = 40, r = 0;
  while (fuel-- > 0) {
    switch (state) {
    case 0:
      x = x * 5 + 1;
      state = x & 16 ? 1 : 2;
      break;
    case 1:
      r += x;
      x >>= 1;
      state = x & 1 ? 3 : 0;
      break;
    case 2:
      if (x > 100)
        goto done;
      x += 13;
      state = 3;
      continue;
    default:
      r ^= 0x55;
      state = r & 2 ? 0 : 2;
    }
  }
done:
  a->io[0][lane] = r;
  a->io[1][lane] = x;
}

/* Exits that meet after an operation each, beside one that does more; some lanes go on early. */
void manyExits(Args *a, int lane) {
  int x = a->i[0][lane], bound = a->i[1][lane] & 31, found = -1, k = 0, skipped = 0;
  for (;;) {
    x = x * 1664525 + 1013904223;
    if (x < -2000000000) {
      found = k + 7;
      break;
    }
    x ^= x >> 9;
    if (x & 4) {
      skipped += k;
      if (x & 8)
        skipped ^= x;
      else if (k > bound)
        goto tooFar;
      if ((x & 48) == 48)
        goto next;
    }
    if ((x & 0x3c0) == 0x140) {
      found = k * 2;
      break;
    }
    found = found * 3 + k;
  next:
    if (++k >= 64) {
      found = 1000;
      break;
    }
  }
  a->io[1][lane] = skipped;
  a->io[0][lane] = found;
  return;
tooFar:
  a->io[1][lane] = x / (k + 1);
  a->io[0][lane] = -found;
}

/*===-- Memory --------------------------------------------------------------===*/

void gathers(Args *a, int lane) {
  a->fo[0][lane] = a->table[a->index[lane]];
  if (a->f[0][lane] > 0)
    a->io[0][lane] = a->itable[a->index[lane]] + a->table[a->index[lane] ^ 1];
  a->fo[1][lane] = a->points[lane].x * a->points[lane].y + a->points[lane].z;
  a->io[1][lane] = a->points[lane].id;
}

/* What idle lanes store must not be what they load: the choice between r and 0 may become one load. */
void idleStores(Args *a, int lane) {
  int own[8] = {0};
  float r = 0;
  if (a->i[0][lane] > 0) {
    own[a->i[1][lane] & 7] = 77;
    r = a->table[a->index[lane]];
  }
  a->fo[0][lane] = r;
  a->io[0][lane] = own[a->i[2][lane] & 7];
}

void scatters(Args *a, int lane) {
  int *row = a->priv[lane];
  for (int k = 0; k < PRIVATE; ++k)
    row[k] = k;
  row[a->b[0][lane] & 15] = a->i[0][lane];
  if (a->i[1][lane] > 0)
    row[a->b[1][lane] & 15] += 1000;
  a->io[0][lane] = row[a->b[2][lane] & 15];
}

void backwards(Args *a, int lane) {
  a->fo[0][LANES - 1 - lane] = a->f[0][LANES - 1 - lane] + a->f[1][lane];
  if (a->f[1][lane] > 0)
    a->io[0][LANES - 1 - lane] = a->i[0][LANES - 1 - lane];
}

void lanePrivateArray(Args *a, int lane) {
  int stack[12], top = 0;
  stack[top++] = a->i[0][lane];
  for (int k = 0; k < a->n; ++k) {
    if (top > 0 && (a->b[0][lane] >> (k & 7) & 1)) {
      a->io[0][lane] ^= stack[--top];
    } else if (top < 12) {
      stack[top++] = k * a->i[1][lane];
    }
  }
  int sum = 0;
  while (top > 0)
    sum = sum * 3 + stack[--top];
  a->io[1][lane] = sum;
}

void initializedArray(Args *a, int lane) {
  float weights[8] = {1, 2, 4, 8, 16, 32, 64, 128};
  short counts[6] = {0};
  weights[a->b[0][lane] & 7] = a->f[0][lane];
  for (int k = 0; k < (a->b[1][lane] & 15); ++k)
    counts[(k * a->b[2][lane]) % 6]++;
  float sum = 0;
  for (int k = 0; k < 8; ++k)
    sum += weights[k] * counts[k % 6];
  a->fo[0][lane] = sum;
}

struct Pair {
  float first;
  double second;
  char tag;
};

static struct Pair __attribute__((noinline)) makePair(float x, double y) {
  struct Pair p = {x + 1, y * 2, (char)(x > y)};
  return p;
}

void structures(Args *a, int lane) {
  struct Pair p = makePair(a->f[0][lane], a->d[0][lane]), q = p;
  if (p.tag)
    q = makePair((float)p.second, p.first);
  struct Pair both[2] = {p, q};
  struct Pair r = both[a->b[0][lane] & 1];
  a->fo[0][lane] = r.first;
  a->dout[0][lane] = r.second;
  a->bo[lane] = r.tag;
}

void pointers(Args *a, int lane) {
  int *p = a->i[0][lane] > 0 ? &a->i[1][lane] : &a->itable[a->index[lane]];
  const float *f = a->table;
  if (a->i[2][lane] > 0)
    f = &a->table[(a->b[0][lane] & 7) + 1];
  a->io[0][lane] = *p;
  a->fo[0][lane] = f[2];
  const float *walk = a->table, *end = a->table + (a->b[1][lane] & 31);
  float sum = 0;
  while (walk != end)
    sum += *walk++;
  a->fo[1][lane] = sum;
}

void bytesAndBools(Args *a, int lane) {
  _Bool x = a->b[0][lane] > 100, y = a->f[0][lane] < 1;
  _Bool flags[4] = {x, y, x != y, x && y};
  a->bo[lane] = flags[a->b[1][lane] & 3] + (flags[0] ? 16 : 0);
  a->so[lane] = (short)((a->b[2][lane] * 257) >> 3);
}

/* Integers of every width, and numbers that no vector register holds. */
void oddWidths(Args *a, int lane) {
  _BitInt(24) x = a->i[0][lane];
  unsigned _BitInt(7) y = a->b[0][lane];
  __int128 product = (__int128)a->l[0][lane] * a->l[1][lane];
  long double e = a->d[0][lane];
  _BitInt(24) steps[4] = {x, y, 3, 5};
  if (a->i[1][lane] > 0) {
    x = x * 3 + y;
    product >>= y & 63;
    e = e * e + x;
    steps[y & 3] += x;
  }
  for (int k = 0; k < (a->b[1][lane] & 3); ++k)
    e = e / 3 + steps[k];
  a->io[0][lane] = x + steps[a->b[2][lane] & 3];
  a->lo[0][lane] = (long long)(product >> 32);
  a->lo[1][lane] = (long long)product;
  a->dout[0][lane] = (double)e;
  a->bo[lane] = (unsigned char)y;
}

/*===-- Division ------------------------------------------------------------===*/

void divisions(Args *a, int lane) {
  int x = a->i[0][lane], y = a->i[1][lane];
  if (y != 0 && !(x == -2147483647 - 1 && y == -1)) {
    a->io[0][lane] = x / y;
    a->io[1][lane] = x % y;
  }
  unsigned char b = a->b[0][lane];
  if (b)
    a->bo[lane] = (unsigned char)(a->b[1][lane] / b + a->b[1][lane] % b);
  long long m = a->l[1][lane];
  if (m > 0)
    a->lo[0][lane] = a->l[0][lane] / m + (unsigned long long)a->l[2][lane] % (unsigned long long)m;
  if (a->i[2][lane] > 0 && a->n > 0)
    a->io[2][lane] = a->m / a->n + x / (a->n + 1);
}

void divisionByConstants(Args *a, int lane) {
  a->io[0][lane] = a->i[0][lane] / 7 + a->i[0][lane] % 10;
  a->io[1][lane] = (unsigned)a->i[1][lane] / 12 + (unsigned)a->i[1][lane] % 1000;
  a->lo[0][lane] = a->l[0][lane] / 1000003;
  a->so[lane] = a->s[0][lane] % 9;
}

/*===-- Calls ---------------------------------------------------------------===*/

static float __attribute__((noinline)) helper(float x, int n, const float *table) {
  float r = x;
  for (int k = 0; k < n; ++k) {
    r = r * 0.5f + table[k];
    if (r > 3)
      return r - k;
  }
  return r;
}

void callsDefined(Args *a, int lane) {
  float r = helper(a->f[0][lane], a->n, a->table);
  if (a->f[1][lane] > 0)
    r += helper(r, a->b[0][lane] & 15, a->table + a->m);
  a->fo[0][lane] = r;
}

static int __attribute__((noinline)) fibonacci(int n) {
  if (n < 2)
    return n;
  return fibonacci(n - 1) + fibonacci(n - 2);
}

static int __attribute__((noinline)) odd(int n);
static int __attribute__((noinline)) even(int n) { return n <= 0 ? 1 : odd(n - 1); }
static int __attribute__((noinline)) odd(int n) { return n <= 0 ? 0 : even(n - 1) + (n == 5); }

void recursion(Args *a, int lane) {
  a->io[0][lane] = fibonacci(a->b[0][lane] & 7);
  if (a->i[0][lane] > 0)
    a->io[1][lane] = even(a->b[1][lane] & 15);
}

void callsOpaque(Args *a, int lane) {
  int r = anyslTestOpaque(a->i[0][lane], a->f[0][lane]);
  if (r > 0)
    r = anyslTestOpaque(r, a->f[1][lane]) + 1;
  for (int k = 0; k < (a->b[0][lane] & 3); ++k)
    r ^= anyslTestOpaque(k, 1);
  if (a->n > 5)
    r += anyslTestOpaque(a->n, a->uniform);
  a->io[0][lane] = r;
}

typedef int (*Function)(int, float);
static int __attribute__((noinline)) twice(int x, float y) { return 2 * x + (y > 1); }

void callsThroughPointer(Args *a, int lane) {
  Function f = a->i[0][lane] > 0 ? anyslTestOpaque : twice;
  a->io[0][lane] = f(a->i[1][lane], a->f[0][lane]);
}

static void __attribute__((noinline)) results(float x, float *r, float *s, int *n) {
  *r = x + 1;
  *s = x * x;
  if (x > 0)
    *n += 5;
}

void callsWithAddresses(Args *a, int lane) {
  float r = 0, s = 0;
  int n = a->i[0][lane];
  results(a->f[0][lane], &r, &s, &n);
  if (r > 1)
    results(s, &s, &r, &n);
  results(s, &a->fo[1][lane], &a->fo[2][lane], &n);
  a->fo[0][lane] = r - s;
  a->io[0][lane] = n;
}

#pragma omp declare simd notinbranch
#pragma omp declare simd inbranch
static float __attribute__((noinline)) declared(float x, float y) { return x > y ? x - y : x * y; }

#pragma omp declare simd uniform(p) linear(lane) simdlen(8)
#pragma omp declare simd uniform(p) linear(lane) simdlen(4)
static float __attribute__((noinline)) declaredLinear(const float *p, int lane) { return p[lane] * 2; }

void callsDeclaredSimd(Args *a, int lane) {
  float r = declared(a->f[0][lane], a->f[1][lane]);
  if (r > 0)
    r += declared(r, a->uniform) + declaredLinear(a->f[2], lane);
  a->fo[0][lane] = r;
}

void unreachableSide(Args *a, int lane) {
  int x = a->b[0][lane];
  if (x > 255)
    __builtin_trap();
  if (x + a->b[1][lane] > 600)
    __builtin_unreachable();
  a->io[0][lane] = x + a->b[1][lane];
}

typedef float Vec4 __attribute__((vector_size(16)));

void vectorsInside(Args *a, int lane) {
  Vec4 v = {a->f[0][lane], a->f[1][lane], a->f[2][lane], 1}, w = v * v + 2;
  if (a->i[0][lane] > 0)
    w = w - v;
  Vec4 s = __builtin_shufflevector(v, w, 0, 5, 2, 7);
  a->fo[0][lane] = s[0] + s[1] * s[2] - s[3];
  a->fo[1][lane] = w[a->b[0][lane] & 3];
}
