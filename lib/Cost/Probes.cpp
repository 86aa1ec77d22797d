//===-- lib/Cost/Probes.cpp - which arguments functions see -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The functions of an instrumented math tier are kept apart, so that their calls are still there
// when the shader has been linked. Code is put before each that notes its arguments. Such a library
// has one more symbol, an array of these for each site:
//
//   struct { double calls, low[2], high[2]; }
//
// Shaders run in one thread there.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Probes.h"
#include "lib/Cost/Mixtures.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/SourceMgr.h"
#include <dlfcn.h>

using namespace llvm;

namespace anysl::cost {
namespace {

constexpr const char *arrayName = "anysl_math_probes";
constexpr unsigned numbersPerSite = 5;

/// The elementary function that is called; empty if it is none.
StringRef functionOf(const CallBase &call) {
  const Function *callee = call.getCalledFunction();
  StringRef name = callee ? callee->getName() : "";
  if (!name.consume_front("anysl_math_"))
    return "";
  name = name.split('.').first; // a tier's own
  return callee->getReturnType()->isFloatTy() ? name.drop_back() : name;
}

FilePosition positionOf(const DILocation &location) {
  return {location.getFilename().str(), location.getLine(), location.getColumn()};
}

/// Notes one call. `array` is that of all sites.
void note(CallBase &call, GlobalVariable &array, size_t site) {
  IRBuilder<> builder(&call);
  Type *number = builder.getDoubleTy();
  auto update = [&](unsigned index, function_ref<Value *(Value *)> change) {
    Value *place = builder.CreateConstInBoundsGEP2_64(array.getValueType(), &array, 0,
                                                      site * numbersPerSite + index);
    builder.CreateStore(change(builder.CreateLoad(number, place)), place);
  };
  update(0, [&](Value *calls) { return builder.CreateFAdd(calls, ConstantFP::get(number, 1)); });
  for (unsigned i = 0; i < std::min(2u, call.arg_size()); ++i) {
    Value *argument = builder.CreateFPExt(call.getArgOperand(i), number);
    // NaN changes neither.
    update(1 + i, [&](Value *low) { return builder.CreateMinNum(argument, low); });
    update(3 + i, [&](Value *high) { return builder.CreateMaxNum(argument, high); });
  }
}

/// Adds code to a linked module that notes the arguments of each call of an elementary function,
/// for the sites of a report. Returns the sites in the order of the module's array.
std::vector<SiteArguments> insertProbes(Module &module, const link::Report &report) {
  std::vector<SiteArguments> sites;
  auto siteAt = [&](const FilePosition &position, StringRef function) {
    for (size_t i = 0; i < sites.size(); ++i)
      if (sites[i].site.name() == Site{position, function.str()}.name())
        return i;
    return sites.size();
  };
  for (const link::ShaderReport &shader : report.shaders)
    for (const link::MathCall &call : shader.mathCalls)
      for (const auto &[function, tier] : call.functions)
        if (siteAt(call.position, function) == sites.size())
          sites.push_back({{call.position, function}});
  auto *type = ArrayType::get(Type::getDoubleTy(module.getContext()),
                              std::max<size_t>(sites.size(), 1) * numbersPerSite);
  std::vector<double> start;
  for (size_t i = 0; i < std::max<size_t>(sites.size(), 1); ++i)
    start.insert(start.end(), {0, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL});
  auto *array = new GlobalVariable(module, type, /*isConstant=*/false, GlobalValue::ExternalLinkage,
                                   ConstantDataArray::get(module.getContext(), start), arrayName);
  SmallVector<std::pair<CallBase *, size_t>> calls;
  for (Function &function : module)
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallBase>(&instruction);
      StringRef name = call ? functionOf(*call) : "";
      if (name.empty())
        continue;
      // From the operator's code outwards to the shader's line that called it.
      for (const DILocation *at = call->getDebugLoc(); at; at = at->getInlinedAt()) {
        size_t site = siteAt(positionOf(*at), name);
        if (site == sites.size())
          continue;
        sites[site].count = std::min(2u, call->arg_size());
        calls.push_back({call, site});
        break;
      }
    }
  for (auto [call, site] : calls)
    note(*call, *array, site);
  return sites;
}

/// Copies a folder of resources by links, but for its exact math tier, whose functions nothing may
/// inline. Throws shade::UserError.
std::string makeInstrumentedTier(const std::string &resourceDir, const std::string &temporary) {
  std::string folder = temporary + "/instrumented";
  auto check = [](std::error_code error) {
    if (error)
      throw shade::UserError("cannot make an instrumented math tier: " + error.message());
  };
  check(sys::fs::create_directories(folder + "/math"));
  std::error_code error;
  for (sys::fs::directory_iterator entry(resourceDir, error), end; !error && entry != end;
       entry.increment(error))
    if (StringRef name = sys::path::filename(entry->path()); name != "math")
      (void)sys::fs::create_link(entry->path(), folder + "/" + name);
  check(error);
  std::string tier = "/math/" + tiers()[0].str() + ".bc";
  LLVMContext context;
  SMDiagnostic diagnostic;
  auto module = parseIRFile(resourceDir + tier, diagnostic, context);
  if (!module)
    throw shade::UserError("cannot read '" + resourceDir + tier + "'");
  for (Function &function : *module)
    if (function.getName().starts_with("anysl_math_") && !function.isDeclaration())
      function.addFnAttr(Attribute::NoInline);
  raw_fd_ostream out(folder + tier, error);
  check(error);
  WriteBitcodeToFile(*module, out);
  return folder;
}

} // namespace

std::vector<SiteArguments> probe(const std::vector<Bench *> &benches, const std::string &real) {
  std::vector<SiteArguments> sites;
  Builder &builder = benches.front()->builder;
  std::string path = builder.buildSpecially(
      real, makeInstrumentedTier(builder.resourceDir(), builder.folder()),
      [&](Module &module, const link::Report &report) { sites = insertProbes(module, report); });
  void *library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  auto *numbers = static_cast<const double *>(library ? dlsym(library, arrayName) : nullptr);
  if (!numbers)
    throw shade::UserError(std::string("cannot read what was noted: ") + dlerror());
  for (Bench *bench : benches)
    bench->runOnce(path);
  for (SiteArguments &site : sites) {
    site.calls = uint64_t(numbers[0]);
    for (unsigned i = 0; i < 2; ++i) {
      site.low[i] = numbers[1 + i];
      site.high[i] = numbers[3 + i];
    }
    numbers += numbersPerSite;
  }
  dlclose(library);
  return sites;
}

} // namespace anysl::cost
