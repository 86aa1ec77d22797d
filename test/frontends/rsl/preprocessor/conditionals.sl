// RUN: rslc -S -o - %s -DLEVEL=3 | FileCheck %s --implicit-check-not=9.900000e+01

#define ON 1
#undef ON
#if defined(ON) || LEVEL < 3
#error this is left out, isn't it
"half a string
#elif LEVEL == 3 && !defined ON && (1 ? 2 : 0) == 2
#define VALUE 42
#elif 1
#define VALUE 99
#else
#define VALUE 99
#endif

#ifndef VALUE
#define VALUE 99
#else
#ifdef NOTHING
#define VALUE 99
#  if 1
#  endif
#endif
#endif

#if 7 / 2 == 3 && 7 % 4 == 3 && -1 < 0 && (1 << 4) == 0x10 && ~0 == -1 && (6 ^ 3) == 5
#define ARITHMETIC 21
#endif
#pragma whatever "this" may say '
#ident "x"
#

surface conditionals() {
  // CHECK: double 4.200000e+01
  // CHECK: double 2.100000e+01
  Ci = VALUE + ARITHMETIC;
}
