/* Loops whose calls GCC turns into calls of vector variants, and the same by hand. */
#include "abi.h"
#include <stdio.h>
#include <string.h>

LOAD_SCALE;
MIXED;
WIDE_RESULT;
ITERATIONS;
BYTES;
LONGS;
STORE_SCALED;

enum { N = 256 };
static float p[N], x[N], fo[N], stored[N];
static double y[N], d1[N], d2[N], d3[N];
static int n[N], io[N], io2[N];
static signed char b[N], bo[N], bo2[N];
static short s[N];
static long long l[N], lo[N], lo2[N];

/* The scalar functions, which no loop calls in its place. */
static float (*volatile scalar_load_scale)(const float *, int, float) = load_scale;
static double (*volatile scalar_mixed)(float, double, int) = mixed;
static double (*volatile scalar_wide_result)(double) = wide_result;
static int (*volatile scalar_iterations)(int) = iterations;
static signed char (*volatile scalar_bytes)(signed char, int) = bytes;
static long long (*volatile scalar_longs)(short, long long) = longs;
static void (*volatile scalar_store_scaled)(float *, float, float) = store_scaled;

static int failures;
#define EXPECT(what, got, want)                                                                    \
  if (memcmp(&(got), &(want), sizeof(got)) != 0) {                                                 \
    printf("%s: element %d differs\n", what, i);                                                   \
    ++failures;                                                                                    \
  }

int main(void) {
  unsigned seed = 1;
  for (int i = 0; i < N; ++i) {
    seed = seed * 1664525 + 1013904223;
    p[i] = (int)(seed >> 20) / 64.f - 20;
    x[i] = (int)(seed >> 12 & 255) / 64.f - 2;
    y[i] = (int)(seed >> 9 & 1023) / 256. - 2;
    n[i] = (int)(seed >> 7) - 1000;
    b[i] = (signed char)(seed >> 13);
    s[i] = (short)(seed >> 11);
    l[i] = (long long)seed * (int)(seed >> 3) - 12345678901ll;
  }

#pragma omp simd
  for (int i = 0; i < N; ++i)
    fo[i] = load_scale(p, i, x[i]);
  for (int i = 0; i < N; ++i) {
    float want = scalar_load_scale(p, i, x[i]);
    EXPECT("load_scale", fo[i], want)
  }

#pragma omp simd
  for (int i = 0; i < N; ++i)
    d1[i] = mixed(x[i], y[i], n[i]);
#pragma omp simd
  for (int i = 0; i < N; ++i)
    if (x[i] > 0)
      d2[i] = mixed(x[i], y[i], n[i]);
#pragma omp simd simdlen(8)
  for (int i = 0; i < N; ++i)
    d3[i] = wide_result(y[i]);
  for (int i = 0; i < N; ++i) {
    double want = scalar_mixed(x[i], y[i], n[i]), masked = x[i] > 0 ? want : 0;
    double third = scalar_wide_result(y[i]);
    EXPECT("mixed", d1[i], want)
    EXPECT("mixed in a branch", d2[i], masked)
    EXPECT("wide_result", d3[i], third)
  }

#pragma omp simd
  for (int i = 0; i < N; ++i)
    io[i] = iterations(n[i]);
#pragma omp simd
  for (int i = 0; i < N; ++i)
    if (n[i] & 1)
      io2[i] = iterations(n[i]);
  for (int i = 0; i < N; ++i) {
    int want = scalar_iterations(n[i]), masked = n[i] & 1 ? want : 0;
    EXPECT("iterations", io[i], want)
    EXPECT("iterations in a branch", io2[i], masked)
  }

#pragma omp simd simdlen(16)
  for (int i = 0; i < N; ++i)
    bo[i] = bytes(b[i], n[i]);
#pragma omp simd simdlen(16)
  for (int i = 0; i < N; ++i)
    if (b[i] > 10)
      bo2[i] = bytes(b[i], n[i]);
#pragma omp simd simdlen(8)
  for (int i = 0; i < N; ++i)
    lo[i] = longs(s[i], l[i]);
#pragma omp simd simdlen(8)
  for (int i = 0; i < N; ++i)
    if (s[i] > 0)
      lo2[i] = longs(s[i], l[i]);
  for (int i = 0; i < N; ++i) {
    signed char want = scalar_bytes(b[i], n[i]), masked = b[i] > 10 ? want : 0;
    long long wantLong = scalar_longs(s[i], l[i]), maskedLong = s[i] > 0 ? wantLong : 0;
    EXPECT("bytes", bo[i], want)
    EXPECT("bytes in a branch", bo2[i], masked)
    EXPECT("longs", lo[i], wantLong)
    EXPECT("longs in a branch", lo2[i], maskedLong)
  }

#pragma omp simd
  for (int i = 0; i < N; ++i)
    store_scaled(stored + i, 3, x[i]);
  for (int i = 0; i < N; ++i) {
    float want = 0;
    scalar_store_scaled(&want, 3, x[i]);
    EXPECT("store_scaled", stored[i], want)
  }
  if (failures == 0)
    puts("all calls agree");
  return failures != 0;
}
