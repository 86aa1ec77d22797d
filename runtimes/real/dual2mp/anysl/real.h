//===-- anysl/real.h - the real of this folder: mp, first and second derivatives -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_REAL_H
#define ANYSL_REAL_H

using anysl_number = double;

#include <anysl/mp.h>

#include <anysl/dual.h>

using anysl_float = anysl::Dual<anysl::Dual<anysl::Mp>>;

#endif // ANYSL_REAL_H
