//===-- lib/STC/MetadataNames.h - the names of STC's metadata -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_METADATANAMES_H
#define ANYSL_STC_METADATANAMES_H

#include "llvm/ADT/StringRef.h"

namespace anysl::stc::metadata {

/// The module's version and producer: !{i32 version, !"producer"}.
inline constexpr llvm::StringLiteral stc = "anysl.stc";
/// One node a shader.
inline constexpr llvm::StringLiteral shaders = "anysl.shaders";
/// On an allocation: !{!"uniform"}; no mark means varying.
inline constexpr llvm::StringLiteral storage = "anysl.storage";
/// On an allocation: the variable's name in the source.
inline constexpr llvm::StringLiteral name = "anysl.name";
/// On a function of the module's own that is no shader: the parameters, as the op table writes
/// them.
inline constexpr llvm::StringLiteral signature = "anysl.signature";

} // namespace anysl::stc::metadata

#endif
