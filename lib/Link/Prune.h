//===-- lib/Link/Prune.h - leaves out what a scene does not call for ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_PRUNE_H
#define ANYSL_LIB_LINK_PRUNE_H

#include "lib/Link/Session.h"
#include "lib/Link/SlotConstants.h"

namespace anysl::link {

/// A parameter's constant, one text a cell.
struct FixedValue {
  Shader *shader;
  unsigned param;
  llvm::SmallVector<llvm::StringRef> texts;
  llvm::SmallVector<double> numbers; ///< unless it is a string
  std::string cause;                 ///< for a scene's: who says so
};

/// The constants that a scene makes of parameters: those that it states, and the defaults of those
/// that it leaves alone (SceneParams.cpp).
void findSceneConstants(Session &session, std::vector<FixedValue> &values);
/// The same of one shader, of which this is given.
void findSceneConstants(Session &session, Shader &shader, const demand::ShaderDemand &given,
                        std::vector<FixedValue> &values);
/// Puts constants into the code of their shaders (SpecializeParams.cpp).
void specialize(llvm::ArrayRef<FixedValue> values);

/// Names of parameters that shaders of the scene may ask others for, or set; nothing: there may be
/// any.
std::optional<std::set<std::string>> askedNames(const Session &session);

/// Notes what a shader's source has before anything is left out (SourceInfo.cpp). Gives false, with
/// an error, if a layer is damaged.
bool noteSource(Session &session, Shader &shader);

/// Whether a surface gives the opacity that it has anyhow: whatever it stores as Oi is Os, or Oi as
/// it was (Opacity.cpp).
bool keepsOpacity(llvm::Function &body);

/// The effects that an operator's definition leads to besides its own, as bits; `neededOnly`:
/// without those of operators that the scene does without.
uint32_t effectsThrough(Session &session, llvm::Function &op, bool neededOnly);

/// Why an operator is not needed; nothing if it may be.
std::optional<std::string> unneededIn(const Session &session, stc::Op op);
/// An assumption's words: "the scene does without lights".
std::string absence(unsigned assumption);
/// What the scene says about calls, for SlotConstants.
SlotConstants::Oracle sceneOracle(const Session &session);

} // namespace anysl::link

#endif
