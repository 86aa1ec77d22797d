//===-- lib/STC/Shader.h - what an STC file says about its shaders ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The contents of the metadata `!anysl.stc` and `!anysl.shaders` (docs/architecture.md) as plain
// structures, written by the builder and read back by the reader.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_SHADER_H
#define ANYSL_STC_SHADER_H

#include "lib/STC/Ops.h"
#include "lib/Support/Diagnostics.h"
#include <string>
#include <vector>

namespace llvm {
class Function;
class Instruction;
} // namespace llvm

namespace anysl::stc {

/// The version of the form itself; a file of another version is refused.
inline constexpr unsigned stcVersion = 1;

/// The kinds of shaders; the values are those of AnyslShaderKind.
enum class ShaderKind : uint8_t { Surface = 1, Displacement, Light, Volume, Imager, Method };
/// The metadata's word for a kind: `surface`.
llvm::StringRef nameOf(ShaderKind kind);
std::optional<ShaderKind> shaderKindNamed(llvm::StringRef name);

/// A parameter of a shader, as its metadata node gives it.
struct ParamInfo {
  std::string name;
  Type type = Type::floatTy;
  Storage storage = Storage::Uniform;
  bool output = false;
  /// 0: not an array.
  unsigned arrayLength = 0;
  unsigned firstCell = 0;

  unsigned elementCount() const { return arrayLength ? arrayLength : 1; }
  unsigned cellCount() const { return elementCount() * info(type).components; }
};

/// A shader global that the shader names.
struct GlobalInfo {
  unsigned id = 0;
  bool read = false;
  bool written = false;
};

struct ShaderInfo {
  std::string name;
  ShaderKind kind = ShaderKind::Surface;
  /// void (ptr ctx): shades one point.
  llvm::Function *body = nullptr;
  /// void (ptr ctx): computes the parameters' defaults.
  llvm::Function *init = nullptr;
  std::vector<ParamInfo> params;
  std::vector<GlobalInfo> globals;

  /// The parameter that cell number `cell` belongs to; null if none does.
  const ParamInfo *paramOfCell(unsigned cell) const;
  unsigned cellCount() const;
};

/// A line of <anysl/Globals.def>.
struct GlobalVariableInfo {
  unsigned id;
  llvm::StringLiteral name;
  Type type;
  unsigned components;
  Storage storage;
  llvm::StringLiteral doc;
  /// No shader can name it; runtimes read it.
  bool isHidden;
};
llvm::ArrayRef<GlobalVariableInfo> allGlobals();
/// The shader global with that number; null if there is none.
const GlobalVariableInfo *globalNumbered(unsigned id);
/// The numbers of the globals from which a runtime takes a global's derivatives by u and v; none if
/// they are constant.
llvm::ArrayRef<unsigned> derivativesOf(unsigned id);

/// The limits that the verifier holds, so that hand-made files cannot ask for absurd storage.
inline constexpr unsigned maxArrayLength = 65536;
inline constexpr unsigned maxCells = 1u << 20;

/// The place in the shader's source that the debug location gives; none if there is none.
FilePosition positionOf(const llvm::Instruction &instruction);

/// The same for code that was inlined: where the shader called what it came from.
FilePosition shaderPositionOf(const llvm::Instruction &instruction);

/// The parameters of a function that an STC module defines: an operator's own, the context for a
/// shader's functions, or those of its `!anysl.signature`. Nothing where that is missing or wrong.
std::optional<llvm::SmallVector<OpParam>> signatureOf(const llvm::Function &function);

} // namespace anysl::stc

#endif
