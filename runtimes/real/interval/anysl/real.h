//===-- anysl/real.h - the real number of this folder: bounds --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_REAL_H
#define ANYSL_REAL_H

using anysl_number = float;

#include <anysl/interval.h>

using anysl_float = anysl::Interval;

#endif // ANYSL_REAL_H
