//===-- lib/Rib/RibState.cpp - the graphics state of a RIB file -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>
#include <set>

using namespace anysl::render;

const std::unordered_map<std::string_view, RibState::Handler> &RibState::table() {
  static const std::unordered_map<std::string_view, Handler> entries = {
#define RIB_REQUEST(name, handler) {#name, &RibState::handler},
#define RIB_ALIAS(name, handler) {#name, &RibState::handler},
#include "lib/Rib/RibRequests.def"
  };
  return entries;
}

RibState::RibState(const std::string &fileName, Warnings &warnings)
    : sceneFile(fileName), warnings(warnings) {
  openArchives.push_back(sceneFile);
}

void RibState::execute(const RibRequest &request) {
  if (recording) {
    record(request);
    return;
  }
  auto entry = table().find(request.name);
  static const std::set<std::string_view> conditionals = {"IfBegin", "ElseIf", "Else", "IfEnd"};
  if (isPassedOver() && !conditionals.contains(request.name))
    return;
  if (entry == table().end()) {
    warnings.warnOnce("request " + request.name, request.where,
                      "request " + request.name + " is not known and is passed over");
    return;
  }
  RibArguments arguments(request, declarations);
  try {
    (this->*entry->second)(arguments);
    if (!arguments.empty() && entry->second != &RibState::ignored)
      throw UserError(request.arguments.back().where,
                      request.name + ": more arguments than expected");
  } catch (const ShapeError &error) {
    warnings.warn(error.where, error.message + "; the shape is left out");
  } catch (const UserError &error) {
    if (!warnings.keepGoing)
      throw;
    warnings.warn(error.where, error.message);
  }
}

std::vector<SceneDescription> RibState::finish(const Location &end) {
  if (recording)
    throw UserError(recording->where, recording->begin + " without its end");
  if (!conditions.empty())
    throw UserError(conditions.back().where, "IfBegin without its end");
  if (!blocks.empty()) {
    static const char *const names[] = {"FrameBegin", "WorldBegin", "AttributeBegin",
                                        "TransformBegin", "SolidBegin"};
    throw UserError(blocks.back().where,
                    std::string(names[size_t(blocks.back().kind)]) + " without its end");
  }
  if (finished.empty())
    throw UserError(end, "the file has no WorldBegin ... WorldEnd, so there is nothing to render");
  finished.front().texturesBefore = std::move(firstTextures);
  return std::move(finished);
}

void RibState::ignored(RibArguments &) {}

void RibState::warnUnknown(const char *what, const std::string &name, const Location &where) {
  warnings.warnOnce(std::string(what) + " " + name, where,
                    std::string(what) + " \"" + name + "\" is not known and has no effect");
}
