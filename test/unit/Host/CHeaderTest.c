/*===-- test/unit/Host/CHeaderTest.c - the host header is C99 -----------------------------*- C -*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===*/

#include <anysl/anysl.h>

/* Called from C++; that this file compiles with -std=c99 -pedantic-errors is most of the test. */
uint32_t versionSeenByC(void) {
  return ANYSL_ABI_VERSION == anysl_abi_version() ? anysl_api_version() : 0;
}
