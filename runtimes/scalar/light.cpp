//===-- runtimes/scalar/light.cpp - light shaders, point by point -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/lights.h>

namespace {

__attribute__((noinline)) void
scalarLight(const AnyslShadeArgs *args, uint32_t point, uint32_t light, anysl_number px,
            anysl_number py, anysl_number pz, anysl_number nx, anysl_number ny, anysl_number nz,
            anysl_number *lx, anysl_number *ly, anysl_number *lz, anysl_number *r, anysl_number *g,
            anysl_number *b, anysl_number *opaqueR, anysl_number *opaqueG, anysl_number *opaqueB) {
  double P[3] = {double(px), double(py), double(pz)}, N[3] = {double(nx), double(ny), double(nz)};
  double result[9] = {0, 0, 0, 0, 0, 0, 1, 1, 1};
  if (args->services->light)
    args->services->light(args->renderer, args, point, light, P, N, result);
  *lx = anysl_number(result[0]), *ly = anysl_number(result[1]), *lz = anysl_number(result[2]);
  *r = anysl_number(result[3]), *g = anysl_number(result[4]), *b = anysl_number(result[5]);
  *opaqueR = anysl_number(result[6]), *opaqueG = anysl_number(result[7]);
  *opaqueB = anysl_number(result[8]);
}

} // namespace

void anysl::askLight(anysl_context *context, int32_t index, const anysl_point &P,
                     const anysl_normal &N, anysl_vector &L, anysl_color &Cl, anysl_color &Ol) {
  anysl_number l[3], c[3], o[3];
  scalarLight(context->args, context->point, uint32_t(index), numberOf(P.x), numberOf(P.y),
              numberOf(P.z), numberOf(N.x), numberOf(N.y), numberOf(N.z), &l[0], &l[1], &l[2],
              &c[0], &c[1], &c[2], &o[0], &o[1], &o[2]);
  L = {l[0], l[1], l[2]};
  Cl = {c[0], c[1], c[2]};
  Ol = {o[0], o[1], o[2]};
}
