//===-- lib/Link/Cpu.cpp - what code for a processor needs --------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Linker.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The instruction sets that LLVM uses for ordinary code where they are there. What a program must
/// ask for by name (AES, transactions, tiles …) is in no shader, so no processor is refused for
/// lacking it.
constexpr StringLiteral usedBySelection[] = {"cmov",
                                             "sse",
                                             "sse2",
                                             "sse3",
                                             "ssse3",
                                             "sse4.1",
                                             "sse4.2",
                                             "popcnt",
                                             "lzcnt",
                                             "bmi",
                                             "bmi2",
                                             "movbe",
                                             "avx",
                                             "f16c",
                                             "fma",
                                             "fma4",
                                             "xop",
                                             "tbm",
                                             "avx2",
                                             "gfni",
                                             "avx512f",
                                             "avx512cd",
                                             "avx512dq",
                                             "avx512bw",
                                             "avx512vl",
                                             "avx512vbmi",
                                             "avx512vbmi2",
                                             "avx512bitalg",
                                             "avx512vpopcntdq",
                                             "avx512vnni",
                                             "avxvnni"};

bool has(const TargetMachine &target, StringRef feature) {
  return target.getMCSubtargetInfo()->checkFeatures(("+" + feature).str());
}

} // namespace

std::string cpuFeatures(const TargetMachine &target) {
  std::string result;
  if (!target.getTargetTriple().isX86())
    return result;
  for (StringRef feature : usedBySelection)
    if (has(target, feature))
      result += (result.empty() ? "" : ",") + feature.str();
  return result;
}

unsigned nativeWidth(const TargetMachine &target) {
  if (!target.getTargetTriple().isX86())
    return 4;
  if (has(target, "avx512f") && has(target, "avx512vl"))
    return 16;
  return has(target, "avx") ? 8 : 4;
}

} // namespace anysl::link
