//===-- lib/Rib/RibMotion.cpp - requests that are stated for several times --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

namespace {

/// Whether two requests differ in their numbers alone.
bool areAlike(const RibRequest &a, const RibRequest &b) {
  if (a.name != b.name || a.arguments.size() != b.arguments.size())
    return false;
  for (size_t i = 0; i < a.arguments.size(); ++i)
    if (a.arguments[i].numbers.size() != b.arguments[i].numbers.size() ||
        a.arguments[i].strings != b.arguments[i].strings)
      return false;
  return true;
}

} // namespace

void RibState::motionBegin(RibArguments &arguments) {
  motionTimes = arguments.rest("the times");
  if (motionTimes.empty())
    throw UserError(arguments.where(), "MotionBegin: no times are given");
  startRecording("MotionBegin", "MotionEnd", "", arguments);
}

void RibState::motionEnd(RibArguments &arguments) {
  throw UserError(arguments.where(), "MotionEnd without MotionBegin");
}

void RibState::doMotion(const OpenRecording &motion) {
  const std::vector<RibRequest> &samples = *motion.requests;
  if (samples.size() != motionTimes.size())
    throw UserError(motion.where, "MotionBegin states " + std::to_string(motionTimes.size()) +
                                      " times, but " + std::to_string(samples.size()) +
                                      " requests follow");
  const CameraDescription &camera = scene.camera;
  if (samples.size() > 1 && camera.shutterClose > camera.shutterOpen)
    warnings.warnOnce(
        "motion", motion.where,
        "motion is not blurred: everything stands where it is when the shutter opens");
  // What lies between two times is between the two numbers.
  size_t next =
      size_t(std::upper_bound(motionTimes.begin(), motionTimes.end(), camera.shutterOpen) -
             motionTimes.begin());
  if (next == 0 || next == samples.size() || !areAlike(samples[next - 1], samples[next])) {
    execute(samples[next == 0 ? 0 : next - 1]);
    return;
  }
  RibRequest between = samples[next - 1];
  double share =
      (camera.shutterOpen - motionTimes[next - 1]) / (motionTimes[next] - motionTimes[next - 1]);
  for (size_t i = 0; i < between.arguments.size(); ++i)
    for (size_t k = 0; k < between.arguments[i].numbers.size(); ++k) {
      double &number = between.arguments[i].numbers[k];
      number += (samples[next].arguments[i].numbers[k] - number) * share;
    }
  execute(between);
}
