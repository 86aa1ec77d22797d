//===-- frontends/rsl/Prelude.cpp - built-ins that are written in RSL -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Prelude.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace anysl::rsl {

// `rayhittest` and `fulltrace` as shaders that were written for BMRT use them (a distance beyond
// 1e10 is a miss), but that the ray that met nothing is always the first. rayserver.h, which came
// with it, makes macros of `trace`, `visibility`, `rayhittest` and `fulltrace` that hand everything
// to `rayserver` in world space.
static constexpr StringLiteral prelude = R"(
float rayhittest(point P; vector R; output point hitP; output normal hitN) {
  float distance;
  if (__trace_hit(P, R, 1e30, "specular", "", "", distance, hitN))
    hitP = P + distance * normalize(R);
  else
    distance = 1e30;
  return distance;
}

float fulltrace(point P; vector R; output color light; output float distance; output point hitP;
                output normal hitN; output point missP; output vector missR) {
  distance = rayhittest(P, R, hitP, hitN);
  if (distance < 1e30) {
    light = color trace(P, R);
    return 0;
  }
  light = 0;
  missP = P;
  missR = R;
  return 1;
}

color rayserver(point P; vector R) {
  return trace(transform("world", "current", P), vtransform("world", "current", R));
}

color rayserver(point P1, P2) {
  return transmission(transform("world", "current", P1), transform("world", "current", P2));
}

float rayserver(point P; vector R; output point hitP; output normal hitN) {
  float reach = rayhittest(transform("world", "current", P), vtransform("world", "current", R), hitP, hitN);
  if (reach < 1e30) {
    hitP = transform("world", hitP);
    hitN = ntransform("world", hitN);
    reach = distance(P, hitP);
  }
  return reach;
}

float rayserver(point P; vector R; output color light; output float distance; output point hitP;
                output normal hitN; output point missP; output vector missR) {
  distance = rayserver(P, R, hitP, hitN);
  if (distance < 1e30) {
    light = rayserver(P, R);
    return 0;
  }
  light = 0;
  missP = P;
  missR = R;
  return 1;
}

color rayserver_indirect(point P; normal N) {
  return indirectdiffuse(transform("world", "current", P), ntransform("world", "current", N));
}

color rayserver_photon(point P; vector I; normal N; vector L) {
  return caustic(transform("world", "current", P), ntransform("world", "current", N));
}
)";

StringRef preludeFor(ArrayRef<Token> tokens) {
  static constexpr StringLiteral names[] = {
#define RSL_WRITTEN(result, name, arguments, meaning) #name,
#include "frontends/rsl/Builtins.def"
  };
  bool isNamed = any_of(tokens, [](const Token &token) {
    return token.is(TokenKind::Identifier) && is_contained(names, token.text);
  });
  return isNamed ? StringRef(prelude) : StringRef();
}

} // namespace anysl::rsl
