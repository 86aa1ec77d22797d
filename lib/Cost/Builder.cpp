//===-- lib/Cost/Builder.cpp - shaders linked in many ways ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Builder.h"
#include "lib/Cost/Mixtures.h"
#include "lib/Emit/Emit.h"
#include "lib/Support/Output.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Instruction.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/MD5.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace anysl::cost {
namespace {

/// Everything that runs: functions and the tables that they use, and not what the library says of
/// itself, which names its math tier.
std::string codeOf(const Module &module) {
  std::string text;
  raw_string_ostream out(text);
  for (const Function &function : module)
    function.print(out);
  for (const GlobalVariable &variable : module.globals())
    if (any_of(variable.users(), [](const User *user) { return isa<Instruction>(user); }))
      variable.print(out);
  return toHex(MD5::hash(arrayRefFromStringRef(out.str())));
}

} // namespace

bool writeChoiceFile(DiagnosticEngine &diags, StringRef path, const Choice &choice,
                     json::Object more) {
  json::Array sites;
  for (const auto &[site, tier] : choice.sites)
    sites.push_back(json::Object{{"file", site.position.file},
                                 {"line", site.position.line},
                                 {"column", site.position.column},
                                 {"function", site.function},
                                 {"tier", tier}});
  more["version"] = 1;
  more["math"] = choice.math;
  more["sites"] = std::move(sites);
  return writeFile(diags, path, [&](raw_pwrite_stream &out) {
    out << formatv("{0:2}\n", json::Value(std::move(more)));
    return Error::success();
  });
}

Builder::Builder(DiagnosticEngine &diags, TargetMachine &target, std::vector<std::string> files,
                 link::LinkOptions given)
    : diags(diags), target(target), inputs(std::move(files)), options(std::move(given)) {
  SmallString<128> folder;
  if (std::error_code error = sys::fs::createUniqueDirectory("anysl-cost", folder)) {
    diags.error("cannot make a folder for temporary files: " + error.message());
    throw Failed();
  }
  temporary = folder.str().str();
}

Builder::~Builder() { sys::fs::remove_directories(temporary); }

std::string Builder::runtimeFor(const std::string &real) const {
  if (!options.runtime.empty() && real != oracle())
    return options.runtime;
  return sys::fs::exists(options.resourceDir + "/runtime/packet." + real + ".bc") ? "packet"
                                                                                  : "scalar";
}

bool Builder::works(const std::string &real) const {
  return sys::fs::exists(options.resourceDir + "/runtime/" + runtimeFor(real) + "." + real + ".bc");
}

// The truth does not depend on the runtime that is asked for.
std::string Builder::oracle() const {
  return sys::fs::exists(options.resourceDir + "/runtime/scalar.mp.bc") ? "mp" : "double";
}

std::string Site::name() const {
  return sys::path::filename(position.file).str() + ":" + std::to_string(position.line) + ":" +
         std::to_string(position.column) + " " + function;
}

std::string Choice::name() const {
  std::string result = math;
  for (const auto &[site, tier] : sites)
    result += "," + site.name() + "=" + tier;
  return result;
}

std::string Builder::newLibrary() {
  SmallString<128> path(temporary);
  sys::path::append(path, std::to_string(libraries++) + ".so");
  return path.str().str();
}

std::string Builder::buildOnce(link::LinkOptions wanted, const std::string &real,
                               function_ref<void(Module &, const link::Report &)> change) {
  wanted.real = real;
  wanted.math = tiers()[0].str();
  wanted.runtime = runtimeFor(real);
  wanted.widths = {1};
  LLVMContext context;
  auto linked = link::linkShaders(diags, context, inputs, wanted, target);
  if (!linked)
    throw Failed();
  if (change)
    change(*linked->module, linked->report);
  std::string path = newLibrary();
  if (!emitModule(diags, *linked->module, target, OutputKind::SharedLibrary, path))
    throw Failed();
  return path;
}

std::string Builder::buildSpecially(const std::string &real, const std::string &resourceDir,
                                    function_ref<void(Module &, const link::Report &)> change) {
  link::LinkOptions wanted = options;
  wanted.resourceDir = resourceDir;
  return buildOnce(std::move(wanted), real, change);
}

std::string Builder::buildTraced(const std::string &real) {
  link::LinkOptions wanted = options;
  wanted.traceOps = true;
  return buildOnce(std::move(wanted), real, nullptr);
}

const Build &Builder::build(const std::string &real, const Choice &choice) {
  auto [place, isNew] = builds.try_emplace({real, choice.name()});
  Build &result = place->second;
  if (!isNew)
    return result;
  link::LinkOptions wanted = options;
  wanted.real = real;
  wanted.math = choice.math;
  if (choice.isMixture() && !options.widths.empty())
    wanted.widths = {*llvm::max_element(options.widths)};
  if (!choice.sites.empty()) {
    wanted.mathChoices = temporary + "/choices.json";
    if (!writeChoiceFile(diags, wanted.mathChoices, choice, {}))
      throw Failed();
  }
  wanted.runtime = runtimeFor(real);
  if (real == "mp") // one point at a time
    wanted.widths = {1};
  std::string path = newLibrary();
  LLVMContext context;
  auto linked = link::linkShaders(diags, context, inputs, wanted, target);
  if (!linked) {
    builds.erase(place);
    throw Failed();
  }
  result = {real, choice, wanted.runtime, path, std::move(linked->report), ""};
  result.code = codeOf(*linked->module);
  if (!emitModule(diags, *linked->module, target, OutputKind::SharedLibrary, path)) {
    builds.erase(place);
    throw Failed();
  }
  return result;
}

} // namespace anysl::cost
