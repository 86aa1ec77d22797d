//===-- lib/Link/LinkModules.cpp - resolves operators and merges modules ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Starts at the shaders and the runtime's own functions and follows every reference to the layer
// whose definition counts: the last one that has any. Only what is reached is read from the files
// and moved into the one module, so a library's size costs nothing. What nobody defines is reported
// with the place in the shader from which it is reached.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/LightCode.h"
#include "lib/Link/NeutralOps.h"
#include "lib/Link/Prune.h"
#include "lib/Link/Session.h"
#include "passes/Vectorize/VectorAbi.h"
#include "passes/Vectorize/Vectorize.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Operator.h"
#include "llvm/Linker/IRMover.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Transforms/Utils/ModuleUtils.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// Where in the shader a reference comes from, and through which operators.
struct Origin {
  FilePosition position;
  std::string shader; ///< empty for the runtime's own needs
  std::string via;    ///< the library's operator that asks, if it is not the shader itself
};

class ModuleLinker {
public:
  explicit ModuleLinker(Session &session) : session(session) {
    for (Layer &layer : session.layers)
      addModule(layer.name, layer.module.get());
    // The user's own files come last and win: they may define operators as well.
    if (Module *unneeded = layerForScene())
      addModule("what the scene does without", unneeded);
    for (auto *files : {&session.files, &session.lightFiles})
      for (stc::StcModule &file : *files)
        addModule("'" + file.path + "'", file.module.get());
  }

  /// Follows everything from the shaders and the runtime on; reads what it meets.
  bool follow() {
    prepareShaders();
    for (StringRef name : {"anysl_runtime_shade_point", "anysl_runtime_init"})
      request(name, {});
    for (StringRef name : runtimeFacts)
      request(name, {});
    for (const auto &names : {tierSymbols(session), noteSymbols(session)})
      for (const std::string &name : names)
        request(name, {});
    for (Shader &shader : session.shaders)
      for (Function *function : {shader.info.body, shader.info.init})
        requestValue(*function, {{}, shader.info.name, ""});
    for (const LightCode &light : session.lightCode)
      if (light.function) {
        requestValue(*light.function, {});
        request(info(stc::Op::linked_light_arrives).symbol(), {});
      }
    while (!worklist.empty()) {
      auto [value, origin] = worklist.pop_back_val();
      scan(*value, origin);
    }
    return good;
  }

  /// Where a shader asks how a value changes; null if none does.
  const Origin *derivativeUse() const { return derivative ? &*derivative : nullptr; }

  /// Whether some shader looks up pictures, whose filters are as wide as derivatives say, or traces
  /// rays that are to carry them.
  bool wantsDerivatives() const { return derivative || looksUp; }

  bool merge();

private:
  struct Input {
    std::string name;
    Module *module;
    SmallSetVector<GlobalValue *, 32> needed;
  };

  /// Stands before the runtime's operators, and is made once, also where linking begins anew.
  Module *layerForScene() {
    SmallVector<stc::Op> ops;
    for (const stc::OpInfo &op : stc::allOps())
      if (unneededIn(session, op.op))
        ops.push_back(op.op);
    if (std::unique_ptr<Module> module = makeUnneededOps(session.context, ops)) {
      session.layers.push_back({"what the scene does without", nullptr, std::move(module)});
      return session.layers.back().module.get();
    }
    return nullptr;
  }

  void addModule(const std::string &name, Module *module) {
    module->setDataLayout(session.target.createDataLayout());
    module->setTargetTriple(session.target.getTargetTriple().str());
    adoptVariantAnnotations(*module);
    inputOf[module] = inputs.size();
    inputs.push_back({name, module, {}});
  }

  /// A shader may be called like any function of a runtime; as an internal function it gets out of
  /// the way when modules are merged.
  void prepareShaders() {
    for (Shader &shader : session.shaders) {
      shader.info.body->setLinkage(GlobalValue::InternalLinkage);
      shader.info.body->setName(shader.symbol + ".body");
      shader.info.init->setLinkage(GlobalValue::InternalLinkage);
      shader.info.init->setName(shader.symbol + ".defaults");
    }
  }

  /// The definition of `name` that counts; null if there is none.
  GlobalValue *definition(StringRef name) const {
    for (const Input &input : reverse(inputs)) {
      GlobalValue *value = input.module->getNamedValue(name);
      if (value && !value->isDeclaration() && !value->hasLocalLinkage())
        return value;
    }
    return nullptr;
  }

  void request(StringRef name, const Origin &origin) {
    if (name.starts_with("llvm.") || name == "anysl_shader_body" || name == "anysl_shader_init" ||
        name.starts_with(derivativeInputPrefix) || name == unknownDerivative ||
        name == derivativeParam || name == derivativeTexture)
      return;
    const stc::OpInfo *op = stc::opOfSymbol(name);
    if (op && op->purity == stc::Purity::Structural)
      return;
    if (op && op->effect == stc::Effect::Derivatives && !derivative)
      derivative = origin;
    looksUp |= op && !unneededIn(session, op->op) &&
               (stc::looksUpPictures(op->effect) ||
                (stc::tracesSurfaces(op->effect) && session.options.rayDerivatives));
    GlobalValue *value = definition(name);
    if (op && (!value || value->getParent() == neutralOps) && !neutralMeaning(op->op).empty())
      declinedOp(*op, origin);
    else if (value)
      requestValue(*value, origin);
    else if (op)
      missingOp(*op, origin);
    else if (name.starts_with("anysl_") && reported.insert(name).second)
      fail({}, "nobody defines '" + name + "', which runtime '" + session.options.runtime +
                   "' with real '" + session.real + "' needs");
    // Anything else belongs to the C library, where the linker of the shared library looks it up.
  }

  void requestValue(GlobalValue &value, const Origin &origin) {
    if (!inputs[inputOf.at(value.getParent())].needed.insert(&value))
      return;
    worklist.push_back({&value, origin});
  }

  void reference(GlobalValue &value, const Origin &origin) {
    if (value.hasLocalLinkage())
      requestValue(value, origin);
    else
      request(value.getName(), origin);
  }

  /// Follows everything that one definition refers to.
  void scan(GlobalValue &value, const Origin &origin) {
    if (auto *variable = dyn_cast<GlobalVariable>(&value)) {
      scanConstant(*variable->getInitializer(), origin);
      return;
    }
    auto *function = dyn_cast<Function>(&value);
    if (!function)
      return;
    if (Error error = function->materialize())
      return fail({}, inputs[inputOf.at(value.getParent())].name +
                          ": damaged bitcode: " + toString(std::move(error)));
    scanVariants(*function, origin);

    bool isShader = none_of(session.layers, [&](const Layer &layer) {
      return layer.module.get() == value.getParent();
    });
    for (Instruction &instruction : instructions(*function)) {
      Origin here = origin;
      if (isShader && instruction.getDebugLoc())
        here.position = stc::positionOf(instruction);
      else if (const stc::OpInfo *op = stc::opOfSymbol(function->getName()))
        here.via = op->symbol();
      for (Value *operand : instruction.operands())
        if (auto *constant = dyn_cast<Constant>(operand))
          scanConstant(*constant, here);
    }
  }

  void scanConstant(Constant &constant, const Origin &origin) {
    if (auto *value = dyn_cast<GlobalValue>(&constant))
      return reference(*value, origin);
    if (isa<ConstantData>(constant))
      return;
    for (Value *operand : constant.operands())
      if (auto *inner = dyn_cast<Constant>(operand))
        scanConstant(*inner, origin);
  }

  /// The wide forms of a function are called by nobody yet; they come along for the widths asked
  /// for.
  void scanVariants(Function &function, const Origin &origin) {
    for (const VariantName &name : variantNames(function.getAttributes())) {
      if (!is_contained(session.widths, name.width))
        continue;
      if (GlobalValue *variant = definition(name.functionName)) {
        requestValue(*variant, origin);
        variants.insert(name.functionName);
      }
    }
  }

  /// Nobody defines an operator that a renderer may decline.
  void declinedOp(const stc::OpInfo &op, const Origin &origin) {
    std::string message =
        "runtime '" + session.options.runtime + "' does not offer '" + op.name.str() + "'";
    if (!origin.shader.empty())
      message += " (shader '" + origin.shader + "')";
    if (session.options.declineIsError)
      return fail(origin.position, message);
    declined.push_back({origin.position, (message + ": " + neutralMeaning(op.op)).str()});
    if (!neutralOps) {
      std::unique_ptr<Module> module = makeNeutralOps(session.context);
      neutralOps = module.get();
      session.layers.push_back({"what is declined", nullptr, std::move(module)});
      addModule(session.layers.back().name, neutralOps);
    }
    requestValue(*neutralOps->getFunction(op.symbol()), origin);
  }

  void missingOp(const stc::OpInfo &op, const Origin &origin) {
    if (!reported.insert(op.symbol()).second)
      return;
    std::string message = "operator '" + op.symbol() + "' is not defined by runtime '" +
                          session.options.runtime + "' with real '" + session.real +
                          "' nor by the shading library";
    if (!origin.via.empty())
      message += "; '" + origin.via + "' needs it";
    if (!origin.shader.empty())
      message += " (shader '" + origin.shader + "')";
    fail(origin.position, message);
  }

  void fail(FilePosition position, const Twine &message) {
    good = false;
    session.diags.error(position, message);
  }

  Session &session;
  std::vector<Input> inputs;
  DenseMap<const Module *, size_t> inputOf;
  SmallVector<std::pair<GlobalValue *, Origin>> worklist;
  StringSet<> reported;
  StringSet<> variants;
  Module *neutralOps = nullptr; ///< made where something is declined
  std::optional<Origin> derivative;
  bool looksUp = false;
  std::vector<std::pair<FilePosition, std::string>> declined; ///< warnings, if this is merged
  bool good = true;
};

bool ModuleLinker::merge() {
  static constexpr WarningGroup Declined{"declined", true};
  for (const auto &[position, message] : declined)
    session.diags.warning(position, Declined, message);
  session.module = std::make_unique<Module>("anysl", session.context);
  session.module->setDataLayout(session.target.createDataLayout());
  session.module->setTargetTriple(session.target.getTargetTriple().str());
  IRMover mover(*session.module);

  // Later layers go first: where two modules declare and define a name, the definition that counts
  // is the only one moved, so the order is a matter of taste; shaders first makes dumps easier to
  // read.
  std::vector<std::unique_ptr<Module>> modules;
  for (auto *files : {&session.files, &session.lightFiles})
    for (stc::StcModule &file : *files)
      modules.push_back(std::move(file.module));
  SmallVector<std::string> lightNames;
  for (const LightCode &light : session.lightCode)
    lightNames.push_back(light.function ? light.function->getName().str() : "");
  for (Layer &layer : session.layers)
    modules.push_back(std::move(layer.module));
  for (std::unique_ptr<Module> &module : modules) {
    Input &input = inputs[inputOf.at(module.get())];
    // The metadata that concerns STC has been read; moved, it would refer to functions that go.
    SmallVector<NamedMDNode *> obsolete;
    for (NamedMDNode &node : module->named_metadata())
      if (node.getName().starts_with("anysl.") || node.getName() == "llvm.ident")
        obsolete.push_back(&node);
    for (NamedMDNode *node : obsolete)
      module->eraseNamedMetadata(node);
    for (StringRef list : {"llvm.used", "llvm.compiler.used", "llvm.global.annotations"})
      if (GlobalVariable *variable = module->getNamedGlobal(list))
        variable->eraseFromParent();
    if (Error error = mover.move(std::move(module), input.needed.getArrayRef(), nullptr, false)) {
      fail({}, input.name + ": " + toString(std::move(error)));
      return false;
    }
  }
  session.files.clear();
  session.lightFiles.clear();
  session.layers.clear();

  for (Shader &shader : session.shaders) {
    shader.info.body = session.module->getFunction(shader.symbol + ".body");
    shader.info.init = session.module->getFunction(shader.symbol + ".defaults");
  }
  for (auto [light, name] : zip_equal(session.lightCode, lightNames))
    light.function = name.empty() ? nullptr : session.module->getFunction(name);
  SmallVector<GlobalValue *> kept;
  for (StringRef name : variants.keys())
    kept.push_back(session.module->getNamedValue(name));
  llvm::sort(kept, [](auto *a, auto *b) { return a->getName() < b->getName(); });
  appendToCompilerUsed(*session.module, kept);
  return true;
}

} // namespace

bool linkModules(Session &session) {
  if (!readLightCode(session))
    return false;
  {
    ModuleLinker linker(session);
    if (!linker.follow())
      return false;
    bool carries = any_of(session.layers,
                          [](const Layer &layer) { return carriesDerivatives(*layer.module); });
    if (!linker.wantsDerivatives() || carries)
      return linker.merge();
    if (!openLayersWithDerivatives(session)) {
      const Origin *use = linker.derivativeUse();
      if (!use) // a lookup does without, at a point
        return linker.merge();
      session.diags.error(use->position, "shader '" + use->shader +
                                             "' asks for derivatives, which runtime '" +
                                             session.options.runtime + "' with real '" +
                                             session.real + "' does not carry");
      return false;
    }
  }
  ModuleLinker linker(session);
  return linker.follow() && linker.merge();
}

} // namespace anysl::link
