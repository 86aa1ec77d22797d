// The shading library: every operator that the shading language itself can express.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

// One module, so that the linker has one to read. Each function of these files is the definition of the operator
// that frontends/rsl/Builtins.def gives for the built-in function of its name and signature.

#include "numbers.sl"
#include "derivatives.sl"
#include "geometry.sl"
#include "color.sl"
#include "light.sl"
#include "rays.sl"
#include "renderer.sl"
