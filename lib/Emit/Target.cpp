//===-- lib/Emit/Target.cpp - the machine that code is made for ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Target.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/TargetSelect.h"
#include "llvm/TargetParser/Host.h"
#include "llvm/TargetParser/SubtargetFeature.h"

using namespace llvm;

namespace anysl {
namespace {

/// Every feature of this machine with its sign, in a fixed order. Virtual machines lack features
/// that the processor's name promises.
std::string nativeFeatures() {
  StringMap<bool> features = sys::getHostCPUFeatures();
  SmallVector<StringRef> names(features.keys());
  llvm::sort(names);
  SubtargetFeatures list;
  for (StringRef name : names)
    list.AddFeature(name, features[name]);
  return list.getString();
}

} // namespace

std::unique_ptr<TargetMachine> makeTarget(DiagnosticEngine &diags, StringRef cpu,
                                          StringRef triple) {
  InitializeNativeTarget();
  InitializeNativeTargetAsmPrinter();
  InitializeNativeTargetAsmParser();
  std::string normalized =
      triple.empty() ? sys::getDefaultTargetTriple() : Triple::normalize(triple);
  std::string reason;
  const Target *target = TargetRegistry::lookupTarget(normalized, reason);
  if (!target || Triple(normalized).getArch() == Triple::UnknownArch) {
    diags.error("there is no target '" + triple + "'");
    return nullptr;
  }
  Triple parsed(normalized);
  if (!parsed.isArch64Bit() || !parsed.isLittleEndian() || !parsed.isOSBinFormatELF()) {
    diags.error("target '" + triple + "' is not supported: shaders need a 64-bit ELF system");
    return nullptr;
  }

  std::string name = cpu.str(), features;
  if (cpu == "native") {
    name = sys::getHostCPUName().str();
    features = nativeFeatures();
  }
  std::unique_ptr<MCSubtargetInfo> subtarget(target->createMCSubtargetInfo(normalized, "", ""));
  if (!subtarget || !subtarget->isCPUStringValid(name)) {
    SmallVector<StringRef> known;
    if (subtarget)
      for (const SubtargetSubTypeKV &entry : subtarget->getAllProcessorDescriptions())
        known.push_back(entry.Key);
    diags.error("there is no processor '" + name + "'" + didYouMean(name, known));
    return nullptr;
  }

  TargetOptions options;
  options.AllowFPOpFusion = FPOpFusion::Strict;
  return std::unique_ptr<TargetMachine>(
      target->createTargetMachine(normalized, name, features, options, Reloc::PIC_,
                                  /*CodeModel=*/std::nullopt, CodeGenOptLevel::Default));
}

} // namespace anysl
