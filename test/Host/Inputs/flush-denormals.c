/* What crtfastmath.o adds to a shared object that gcc links with -ffast-math. */
#include <xmmintrin.h>

__attribute__((constructor)) static void flushDenormals(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }
