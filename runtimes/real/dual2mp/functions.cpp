//===-- runtimes/real/dual2mp/functions.cpp - arithmetic of Mp, as in mp -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "../mp/functions.cpp"
