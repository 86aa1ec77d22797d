/* Functions that one compiler widens and another calls. Clang wants the pragmas on the definitions, GCC
   on the declarations it calls, so each stands here once as a macro. */
#define PRAGMA(text) _Pragma(#text)
#define BOTH(...) PRAGMA(omp declare simd notinbranch __VA_ARGS__) PRAGMA(omp declare simd inbranch __VA_ARGS__)

#define LOAD_SCALE                                                                                 \
  BOTH(uniform(p) linear(i)) BOTH(uniform(p) linear(i) simdlen(8))                                 \
  float load_scale(const float *p, int i, float x)
#define MIXED BOTH() BOTH(simdlen(8)) double mixed(float x, double y, int n)
#define WIDE_RESULT BOTH() BOTH(simdlen(8)) double wide_result(double x)
#define ITERATIONS BOTH(simdlen(4)) BOTH(simdlen(8)) int iterations(int n)
#define BYTES BOTH(simdlen(16)) BOTH(simdlen(8)) signed char bytes(signed char x, int y)
#define LONGS BOTH(simdlen(8)) long long longs(short x, long long y)
#define STORE_SCALED                                                                               \
  BOTH(linear(p) uniform(scale)) BOTH(linear(p) uniform(scale) simdlen(8))                         \
  void store_scaled(float *p, float scale, float x)
