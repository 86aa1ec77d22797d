// Records of active lanes are read and written as whole vectors under a mask that is spread over
// them, where processors have masked loads and stores. Nothing of an idle lane's record is touched:
// half of those here lie where memory ends.
//
// RUN: clang -O1 -march=x86-64-v3 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<verify>' %t.bc -o %t.wide.bc
// RUN: llvm-dis %t.wide.bc -o - | FileCheck %s
// RUN: clang -O2 %t.wide.bc -o %t.run
// RUN: %if avx512 %{ %t.run %}
//
// CHECK-LABEL: define {{.*}}@_ZGVdN8uuul_turn3(
// CHECK-NOT: masked.gather
// CHECK-COUNT-3: call <8 x float> @llvm.masked.load.v8f32
// CHECK-NOT: masked.scatter
// CHECK-COUNT-3: call void @llvm.masked.store.v8f32
// CHECK: ret void
// CHECK-LABEL: define {{.*}}@_ZGVeN16uuul_turn3(
// CHECK-NOT: masked.gather
// CHECK-COUNT-3: call <16 x float> @llvm.masked.load.v16f32
// CHECK-NOT: masked.scatter
// CHECK-COUNT-3: call void @llvm.masked.store.v16f32
// CHECK: ret void
//
// Without masked loads, whole vectors where all lanes are active.
// RUN: clang -O1 -march=x86-64-v2 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=4;verify>' %t.bc -o %t.wide.bc
// RUN: llvm-dis %t.wide.bc -o - | FileCheck --check-prefix=SSE %s
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<verify>' %t.bc -o %t.wide.bc
// RUN: clang -O2 %t.wide.bc -o %t.run
// RUN: %if avx512 %{ %t.run %}
// SSE-LABEL: define {{.*}}@_ZGVbN4uuul_turn3(
// SSE: all:
// SSE-COUNT-3: load <4 x float>
// SSE-COUNT-3: store <4 x float>
// SSE: some:
// SSE: ret void
//
// One member alone is gathered.
// CHECK-LABEL: define {{.*}}@_ZGVeN16uuul_part(
// CHECK: masked.gather
// CHECK-NOT: masked.scatter
// CHECK: masked.store
// CHECK: ret void
#include <stdio.h>
#include <sys/mman.h>

#define WIDE(isa, width, name)                                                                     \
  void name##isa(const float *in, float *out, const int *on,                                       \
                 int i) __asm__("_ZGV" #isa "N" #width "uuul_" #name);
#define ALL(name) WIDE(b, 4, name) WIDE(d, 8, name) WIDE(e, 16, name)

ALL(turn2)
ALL(turn3) ALL(turn4) ALL(part) ALL(doubles) ALL(aligned)

    typedef void Kernel(const float *, float *, const int *, int);

enum { lanes = 32 };

/// Runs with the lanes from \p first on idle, and those that \p pattern has no bit for.
static int differs(const char *name, Kernel *one, Kernel *many, int width, int floats, int first,
                   unsigned pattern) {
  static float *page[3];
  for (int k = 0; k < 3 && !page[k]; ++k) {
    page[k] = mmap(0, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    mprotect((char *)page[k] + 4096, 4096, PROT_NONE);
  }
  // The last record that any lane may touch ends where the page does.
  float *in = page[0] + 1024 - first * floats, *wide = page[1] + 1024 - first * floats,
        *scalar = page[2] + 1024 - first * floats;
  int on[lanes];
  for (int k = 0; k < first * floats; ++k)
    in[k] = (float)k + 0.5f, wide[k] = scalar[k] = -1;
  for (int i = 0; i < lanes; ++i)
    on[i] = i < first && (pattern >> i & 1);
  for (int i = 0; i < lanes; ++i)
    one(in, scalar, on, i);
  for (int i = 0; i < lanes; i += width)
    many(in, wide, on, i);
  for (int k = 0; k < first * floats; ++k)
    if (wide[k] != scalar[k]) {
      printf("%s, %d lanes: %g instead of %g at %d\n", name, width, wide[k], scalar[k], k);
      return 1;
    }
  return 0;
}

#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void turn2(const float *in, float *out, const int *on, int i) {
  if (on[i]) {
    float x = in[2 * i], y = in[2 * i + 1];
    out[2 * i + 1] = x;
    out[2 * i] = y;
  }
}
#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void turn3(const float *in, float *out, const int *on, int i) {
  if (on[i]) {
    float x = in[3 * i], y = in[3 * i + 1], z = in[3 * i + 2];
    out[3 * i] = z;
    out[3 * i + 1] = x;
    out[3 * i + 2] = y;
  }
}
#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void turn4(const float *in, float *out, const int *on, int i) {
  if (on[i]) {
    float x = in[4 * i], y = in[4 * i + 1], z = in[4 * i + 2], w = in[4 * i + 3];
    out[4 * i] = z;
    out[4 * i + 2] = w;
    out[4 * i + 1] = y;
    out[4 * i + 3] = x;
  }
}
/// One of three members is read, two of four are written.
#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void part(const float *in, float *out, const int *on, int i) {
  if (on[i]) {
    float y = in[3 * i + 1];
    out[4 * i + 3] = y;
    out[4 * i + 1] = -y;
  }
}
#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void doubles(const float *in, float *out, const int *on, int i) {
  const double *from = (const double *)in;
  double *to = (double *)out;
  if (on[i]) {
    double x = from[3 * i], z = from[3 * i + 2];
    to[3 * i + 1] = z;
    to[3 * i + 2] = x;
  }
}

/// Addresses of active lanes are aligned, that of an idle first lane need not be.
#pragma omp declare simd notinbranch uniform(in, out, on) linear(i : 1)
void aligned(const float *in, float *out, const int *on, int i) {
  if (on[i]) {
    const float *record = __builtin_assume_aligned(in + 3 * i, 64);
    out[i] = record[0] + record[1] * record[2];
  }
}
static int differsAligned(void) {
  static _Alignas(64) float in[3 * lanes], out[3][lanes], scalar[lanes];
  static int on[lanes];
  for (int k = 0; k < 3 * lanes; ++k)
    in[k] = (float)k;
  on[16] = 1;
  aligned(in, scalar, on, 16);
  alignedb(in, out[0], on, 13);
  alignedd(in, out[1], on, 9);
  alignede(in, out[2], on, 1);
  for (int k = 0; k < 3; ++k)
    if (out[k][16] != scalar[16]) {
      printf("aligned: %g instead of %g\n", out[k][16], scalar[16]);
      return 1;
    }
  return 0;
}

#define TRY(name, floats)                                                                          \
  for (int first = 0; first <= lanes; ++first)                                                     \
    for (unsigned pattern = 0; pattern < sizeof patterns / sizeof *patterns; ++pattern)            \
      bad |= differs(#name, name, name##b, 4, floats, first, patterns[pattern]) |                  \
             differs(#name, name, name##d, 8, floats, first, patterns[pattern]) |                  \
             differs(#name, name, name##e, 16, floats, first, patterns[pattern]);

int main(void) {
  static const unsigned patterns[] = {~0u, 0u, 0x55555555u, 0x80010180u, 0xfffefff7u, 0x2468ace1u};
  int bad = differsAligned();
  TRY(turn2, 2) TRY(turn3, 3) TRY(turn4, 4) TRY(part, 4) TRY(doubles, 6) return bad;
}
