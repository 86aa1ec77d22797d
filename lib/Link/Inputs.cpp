//===-- lib/Link/Inputs.cpp - finds and opens what is linked ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/LightCode.h"
#include "lib/Link/SceneLights.h"
#include "lib/STC/Writer.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/IR/Constants.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

namespace anysl::link {
namespace {

constexpr StringLiteral shadelibName = "shadelib.stc.bc";

/// The file names of a folder without their suffix `.bc`, sorted.
std::vector<std::string> modulesIn(const Twine &folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (sys::fs::directory_iterator entry(folder, code), end; entry != end && !code;
       entry.increment(code)) {
    StringRef file = sys::path::filename(entry->path());
    if (file.consume_back(".bc"))
      names.push_back(file.str());
  }
  llvm::sort(names);
  return names;
}

std::string join(const std::vector<std::string> &names) {
  std::string result;
  for (const std::string &name : names)
    result += (result.empty() ? "" : ", ") + name;
  return result.empty() ? "none" : result;
}

/// Reports a name that stands for no module of a folder.
bool unknownName(Session &session, StringRef what, StringRef name,
                 const std::vector<std::string> &known) {
  SmallVector<StringRef> candidates(known.begin(), known.end());
  session.diags.error("there is no " + what + " '" + name + "'" + didYouMean(name, candidates) +
                      (known.empty()
                           ? " (none is installed in '" + session.options.resourceDir + "')"
                           : " (there are: " + join(known) + ")"));
  return false;
}

/// Opens one layer; function bodies stay unread.
bool openLayer(Session &session, StringRef name, const Twine &path) {
  SmallString<256> file;
  path.toVector(file);
  auto refuse = [&](const Twine &reason) {
    session.diags.error(FilePosition{file.str().str()}, name + ": " + reason);
    return false;
  };
  auto buffer = MemoryBuffer::getFile(file);
  if (!buffer)
    return refuse("cannot read the file: " + buffer.getError().message());
  if (stc::checkChecksum((*buffer)->getBuffer()) == stc::Checksum::Wrong)
    return refuse("damaged bitcode: the contents do not match their checksum");
  auto module = getLazyBitcodeModule((*buffer)->getMemBufferRef(), session.context);
  if (!module)
    return refuse("damaged bitcode: " + toString(module.takeError()));
  (*module)->setDataLayout(session.target.createDataLayout());
  (*module)->setTargetTriple(session.target.getTargetTriple().str());
  session.layers.push_back({name.str(), std::move(*buffer), std::move(*module)});
  return true;
}

} // namespace

std::vector<std::string> availableRuntimes(StringRef resourceDir) {
  std::vector<std::string> names;
  for (StringRef name : modulesIn(resourceDir + "/runtime"))
    names.push_back(name.rsplit('.').first.str());
  names.erase(unique(names), names.end());
  return names;
}

std::vector<std::string> availableReals(StringRef resourceDir) {
  return modulesIn(resourceDir + "/real");
}

std::vector<std::string> availableMathTiers(StringRef resourceDir) {
  return modulesIn(resourceDir + "/math");
}

/// The real whose numbers have one derivative more, the least that is beyond a plain one's; empty
/// if there is none.
static StringRef differentiable(StringRef real) {
  return StringSwitch<StringRef>(real)
      .Case("float", "dual")
      .Case("double", "dualdouble")
      .Case("mp", "dualmp")
      .Case("dual", "dual2")
      .Case("dualdouble", "dual2double")
      .Default("");
}

StringRef realOfHigherOrder(const Session &session) {
  StringRef real = differentiable(session.real);
  bool isThere = is_contained(modulesIn(session.options.resourceDir + "/runtime"),
                              (session.options.runtime + "." + real).str());
  return isThere ? real : StringRef();
}

bool openLayersWithDerivatives(Session &session) {
  StringRef real = realOfHigherOrder(session);
  if (real.empty())
    return false;
  session.real = real.str();
  session.report.real = session.real;
  session.layers.clear();
  return openLayers(session);
}

/// A real that shades one point at a time has no other width.
static bool adaptWidths(Session &session, const Module &real) {
  if (!constantOf(real, "anysl_real_is_scalar").value_or(0) || session.widths.back() == 1)
    return true;
  if (!session.options.widths.empty()) {
    session.diags.error("real '" + session.real +
                        "' shades one point at a time: there is no width " +
                        Twine(session.widths.back()) + " (link it with --width 1)");
    return false;
  }
  session.widths = {1};
  return true;
}

/// Gives a real as many bits as the options ask for.
static bool adaptPrecision(Session &session, Module &real) {
  unsigned bits = session.options.precision;
  auto *precision = real.getNamedGlobal("anysl_real_precision");
  if (bits && !precision) {
    session.diags.error("real '" + session.real + "' has one precision only");
    return false;
  }
  if (!precision)
    return true;
  constexpr unsigned least = 53; // what double has, which a host's numbers are given in
  auto most = constantOf(real, "anysl_real_precision_limit").value_or(least);
  if (bits && (bits < least || bits > most)) {
    session.diags.error("real '" + session.real + "' has from " + Twine(least) + " to " +
                        Twine(most) + " bits, not " + Twine(bits));
    return false;
  }
  if (bits)
    precision->setInitializer(ConstantInt::get(precision->getValueType(), bits));
  precision->setLinkage(GlobalValue::ExternalLinkage);
  return true;
}

/// Lets the rays of a runtime carry derivatives if the options say so.
static void adaptRays(const Session &session, Module &runtime) {
  auto *carry = runtime.getNamedGlobal("anysl_rays_carry_derivatives");
  if (!carry)
    return;
  carry->setInitializer(ConstantInt::get(carry->getValueType(), session.options.rayDerivatives));
  carry->setLinkage(GlobalValue::ExternalLinkage);
}

/// Tells a runtime what the scene does without, in the bits of AnyslDemandInfo::assumes.
static void adaptToScene(const Session &session, Module &runtime) {
  auto *assumes = runtime.getNamedGlobal("anysl_scene_assumes");
  if (!assumes)
    return;
  uint32_t bits = session.options.scene ? session.options.scene->assumptions() : 0;
  assumes->setInitializer(ConstantInt::get(assumes->getValueType(), bits));
  assumes->setLinkage(GlobalValue::ExternalLinkage);
}

static bool openTiers(Session &session) {
  std::vector<std::string> tiers = session.math.tiers();
  for (const std::string &tier : tiers) {
    if (!openLayer(session, "math tier '" + tier + "'",
                   session.options.resourceDir + "/math/" + tier + ".bc"))
      return false;
    if (tiers.size() > 1)
      separateTier(session, tier, *session.layers.back().module);
  }
  return true;
}

static bool adaptToReal(Session &session, Module &real) {
  session.notesBounds = hasBounds(real);
  return adaptWidths(session, real) && adaptPrecision(session, real);
}

std::optional<uint64_t> constantOf(const Module &module, StringRef name) {
  const GlobalVariable *variable = module.getNamedGlobal(name);
  if (!variable || !variable->hasInitializer())
    return std::nullopt;
  auto *value = dyn_cast<ConstantInt>(variable->getInitializer());
  return value ? std::optional<uint64_t>(value->getZExtValue()) : std::nullopt;
}

/// Over those of the real.
static bool openPlainOperators(Session &session) {
  if (!session.options.plainOperators)
    return true;
  std::string folder = session.options.resourceDir + "/plain";
  if (is_contained(modulesIn(folder), session.real))
    return openLayer(session, "plain operators", folder + "/" + session.real + ".bc");
  session.diags.error("there are no plain operators for real '" + session.real + "'");
  return false;
}

bool openLayers(Session &session) {
  const LinkOptions &options = session.options;
  StringRef folder = options.resourceDir;
  auto runtimes = availableRuntimes(folder), reals = availableReals(folder),
       tiers = availableMathTiers(folder);
  if (!is_contained(runtimes, options.runtime))
    return unknownName(session, "runtime", options.runtime, runtimes);
  if (!is_contained(reals, session.real))
    return unknownName(session, "real", session.real, reals);
  session.math = {};
  bool isRead = options.mathChoices.empty()
                    ? readMathChoice(session.diags, options.math, "", tiers, session.math)
                    : readMathChoiceFile(session.diags, options.mathChoices, tiers, session.math);
  if (!isRead)
    return false;
  session.report.math = session.math.text();
  if (!is_contained(modulesIn(folder + "/runtime"), options.runtime + "." + session.real)) {
    session.diags.error("runtime '" + options.runtime + "' does not work with real '" +
                        session.real + "'");
    return false;
  }
  bool areOpen =
      openLayer(session, "the shading library", folder + "/" + shadelibName) &&
      openLayer(session, "real '" + session.real + "'", folder + "/real/" + session.real + ".bc") &&
      adaptToReal(session, *session.layers.back().module) && openPlainOperators(session) &&
      openLayer(session, "runtime '" + options.runtime + "'",
                folder + "/runtime/" + options.runtime + "." + session.real + ".bc");
  if (!areOpen)
    return false;
  adaptRays(session, *session.layers.back().module);
  adaptToScene(session, *session.layers.back().module);
  adaptLights(session, *session.layers.back().module);
  return openTiers(session);
}

bool readInputs(Session &session, ArrayRef<std::string> files) {
  StringMap<std::string> seen;
  bool good = true;
  for (const std::string &path : files) {
    auto file = stc::readFile(session.diags, session.context, path);
    if (!file) {
      good = false;
      continue;
    }
    for (const stc::ShaderInfo &info : file->shaders) {
      auto [entry, isNew] = seen.try_emplace((nameOf(info.kind) + ":" + info.name).str(), path);
      if (!isNew) {
        session.diags.error(FilePosition{path}, nameOf(info.kind) + " shader '" + info.name +
                                                    "' is also in '" + entry->second + "'");
        good = false;
        continue;
      }
      Shader shader;
      shader.info = info;
      shader.symbol = info.name;
      if (any_of(session.shaders,
                 [&](const Shader &other) { return other.info.name == info.name; }))
        shader.symbol += "." + nameOf(info.kind).str();
      shader.fixed.resize(info.params.size());
      shader.report.name = info.name;
      shader.report.kind = nameOf(info.kind).str();
      shader.report.stcInstructions = info.body->getInstructionCount();
      session.shaders.push_back(std::move(shader));
    }
    session.files.push_back(std::move(*file));
  }
  if (good && session.shaders.empty()) {
    session.diags.error("there is no shader in " +
                        (files.size() == 1 ? "'" + files[0] + "'" : "these files"));
    good = false;
  }
  if (!good || !openLayers(session))
    return false;
  for (Shader &shader : session.shaders)
    if (shader.info.kind == stc::ShaderKind::Light)
      shader.code = codeOf(session, shader.info);
  return true;
}

} // namespace anysl::link
