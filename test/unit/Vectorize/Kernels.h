/*===-- test/unit/Vectorize/Kernels.h - what the kernels of the tests work on ------------*- C -*-===*
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===*/

#ifndef ANYSL_TEST_UNIT_VECTORIZE_KERNELS_H
#define ANYSL_TEST_UNIT_VECTORIZE_KERNELS_H

enum { LANES = 64, TABLE = 256, PRIVATE = 16, INPUTS = 3, OUTPUTS = 3 };

/* Each array has LANES elements, one a lane; a kernel runs for lane and lane + 1 ... lane + W - 1. */
struct Args {
  float f[INPUTS][LANES];
  double d[INPUTS][LANES];
  int i[INPUTS][LANES];       /* between -100 and 100 mostly, extremes now and then */
  long long l[INPUTS][LANES];
  short s[INPUTS][LANES];
  unsigned char b[INPUTS][LANES];
  unsigned index[LANES];      /* below TABLE */
  struct { float x, y, z; int id; } points[LANES];
  float table[TABLE];
  int itable[TABLE];
  int n, m;                   /* the same for all lanes, from 0 to 12 */
  float uniform;
  float fo[OUTPUTS][LANES];
  double dout[OUTPUTS][LANES];
  int io[OUTPUTS][LANES];
  long long lo[OUTPUTS][LANES];
  short so[LANES];
  unsigned char bo[LANES];
  int priv[LANES][PRIVATE];   /* a lane's own row */
};

#endif
