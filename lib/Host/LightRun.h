//===-- lib/Host/LightRun.h - one run of a light shader -----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A light shader is asked about a few points of another shader's batch; it gets a batch of its own
// in which those points have the same numbers, so that its services find what the renderer knows
// about them, and its own random sequences. Only points that ask are run, in runs of consecutive
// ones: the renderer must not see a ray that no point asks for.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_HOST_LIGHTRUN_H
#define ANYSL_LIB_HOST_LIGHTRUN_H

#include "lib/Host/Internal.h"

namespace anysl::host {

inline constexpr uint32_t laneCount = 16;
inline constexpr uint32_t resultCount = 9;                         // L, Cl, Ol
inline constexpr size_t cellBytes = laneCount * sizeof(AnyslCell); ///< of all lanes of a value

/// A question: positions and normals of lanes.
struct Question {
  double P[3][laneCount], N[3][laneCount];
};

/// What a light gave at the points base to base + 15.
struct Answer {
  uint32_t base = 0;
  uint32_t known = 0; ///< lanes that hold an answer
  Question asked;
  double result[resultCount][laneCount];
  AlignedBuffer outputs; ///< of the shader's output parameters, as it stores them
};

/// Where an output parameter's values lie in an answer; element e, component c of a lane is at
/// SoA: [(e*n + c) * 16 + lane], AoS: [(e*16 + lane) * n + c].
template <class Value>
Value *outputPlace(const Answer &answer, const AnyslParamInfo &param) {
  return reinterpret_cast<Value *>(answer.outputs.get() + param.first_cell * cellBytes);
}

inline bool isOutput(const AnyslParamInfo &param) { return param.flags & ANYSL_PARAM_OUTPUT; }

/// Answers a question for the points first + lane of a batch that a light shader does not know yet.
/// \p cells are its parameters.
void answerLanes(const AnyslShadeArgs &surface, uint32_t light, const AnyslCell *cells,
                 uint32_t first, uint32_t lanes, const Question &question, Answer &answer);

/// The surface's global that is what a light shader sees as `global`.
int globalOfSurface(int global);

/// An output parameter's values at a lane, all elements.
void readOutput(const AnyslInstance &light, const Answer &answer, const AnyslParamInfo &param,
                uint32_t lane, AnyslCell *cells);

} // namespace anysl::host

#endif
