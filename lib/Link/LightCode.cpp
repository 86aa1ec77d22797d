//===-- lib/Link/LightCode.cpp - light shaders that are linked into surfaces --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A renderer's answer to light_sample of a light shader is what its library gives for the points in
// question: L, Cl and Ol that it stores, where it was given Ps and Ns, its own place, and the
// parameters' values of its instance (lib/Host/LightRun.cpp). That is a function of these, and here
// it becomes one, of threaded code: the globals are operands, and parameters are the constants that
// the scene knows, or read from the batch's light, whatever they are there.
//
// A light that looks up a picture, asks for a space or a random number, or reads a global of the
// surface, is run for the renderer's own sake: what it is told depends on who asks. Derivatives do
// not go through a renderer, so that where numbers carry them all lights stay the renderer's.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/LightCode.h"
#include "lib/Link/Needs.h"
#include "lib/Link/OperatorWriter.h"
#include "lib/Link/Prune.h"
#include "lib/Link/SceneLights.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/ModuleSlotTracker.h"
#include "llvm/Support/xxhash.h"
#include "llvm/Transforms/Utils/Cloning.h"
#include "llvm/Transforms/Utils/Local.h"
#include <anysl/abi.h>

using namespace llvm;

namespace anysl::link {

using stc::Op;

namespace {

/// How many instructions of threaded code a light may have.
constexpr unsigned mostInstructions = 500;

/// What takes the place of a parameter's load.
std::optional<Op> loadOfLight(Op load) {
  switch (load) {
  case Op::load_param_float:
    return Op::linked_light_float;
  case Op::load_param_color:
    return Op::linked_light_color;
  case Op::load_param_vector:
    return Op::linked_light_vector;
  case Op::load_param_matrix:
    return Op::linked_light_matrix;
  case Op::load_param_string:
    return Op::linked_light_string;
  default:
    return std::nullopt;
  }
}

enum Argument : unsigned { Context, P, N, L, Cl, Ol, ArgumentCount };

/// The argument that a global is; nothing if it is none.
std::optional<Argument> argumentOf(uint64_t global) {
  switch (global) {
  case ANYSL_Ps:
    return P;
  case ANYSL_Ns:
    return N;
  case ANYSL_L:
    return L;
  case ANYSL_Cl:
    return Cl;
  case ANYSL_Ol:
    return Ol;
  default:
    return std::nullopt;
  }
}

bool isPlace(uint64_t global) {
  return global == ANYSL_P || global == ANYSL_N || global == ANYSL_Ng;
}

bool storesVarying(const stc::OpInfo &op) {
  return op.purity == stc::Purity::Writes && idKind(op) == stc::IdKind::Param;
}

/// Whether all that an operator does can be done in a surface.
bool fits(const CallInst &call, const stc::OpInfo &op) {
  if (op.purity == stc::Purity::Structural || loadOfLight(op.op) || storesVarying(op))
    return true;
  if (idKind(op) == stc::IdKind::Global) {
    uint64_t global = idOf(call, op);
    auto argument = argumentOf(global);
    bool isResult = argument && *argument >= L;
    return op.purity == stc::Purity::Writes ? isResult : argument || isPlace(global);
  }
  return op.purity == stc::Purity::Pure && op.effect != stc::Effect::Derivatives &&
         !op.takesContext();
}

/// Whether a light's code can be run in a surface. One that gives no L is ambient.
bool fits(Function &body) {
  bool shines = false;
  for (const Instruction &instruction : instructions(body)) {
    auto *call = dyn_cast<CallInst>(&instruction);
    if (!call)
      continue;
    const stc::OpInfo *op = opOf(*call);
    if (!op || !fits(*call, *op))
      return false;
    shines |= op->purity == stc::Purity::Writes && idKind(*op) == stc::IdKind::Global &&
              idOf(*call, *op) == ANYSL_L;
  }
  return shines && body.getInstructionCount() <= mostInstructions;
}

/// Makes parameters constants of which the scene knows the light's value.
std::vector<LightCell> fixCells(Session &session, const stc::ShaderInfo &info,
                                const demand::ShaderDemand &given) {
  Shader light;
  light.info = info;
  light.fixed.resize(info.params.size());
  std::vector<FixedValue> values;
  findSceneConstants(session, light, given, values);
  specialize(values);
  std::vector<LightCell> result;
  for (const FixedValue &value : values) {
    const stc::ParamInfo &param = info.params[value.param];
    for (unsigned i = 0; i < param.cellCount(); ++i)
      if (value.texts.empty())
        result.push_back({param.firstCell + i, param.name, std::nullopt, value.numbers[i]});
      else
        result.push_back({param.firstCell + i, param.name, value.texts[i].str()});
  }
  return result;
}

/// A renderer gives lights no values of parameters point by point.
void decideBound(Function &body) {
  for (Instruction &instruction : make_early_inc_range(instructions(body)))
    if (const stc::OpInfo *op = opOf(instruction); op && op->op == Op::param_is_bound) {
      instruction.replaceAllUsesWith(ConstantInt::getFalse(body.getContext()));
      instruction.eraseFromParent();
    }
  for (BasicBlock &block : body)
    ConstantFoldTerminator(&block);
  removeUnreachableBlocks(body);
}

/// Puts the operands of the function, and the light's, in the place of what a call asks for.
void rewrite(CallInst &call, const stc::OpInfo &op, Function &function, Constant *index,
             OperatorWriter &writer) {
  auto argument = [&](unsigned number) { return function.getArg(number); };
  writer.before(call);
  if (auto load = loadOfLight(op.op)) {
    writer.call(*load, {call.getArgOperand(0), argument(Context), index, call.getArgOperand(2)});
  } else if (idKind(op) == stc::IdKind::Global) {
    uint64_t global = idOf(call, op);
    bool isStore = op.purity == stc::Purity::Writes;
    Value *slot = call.getArgOperand(isStore ? 2 : 0);
    auto its = argumentOf(global);
    bool isColor = its && *its >= Cl;
    if (its)
      writer.call(isColor ? Op::copy_color : Op::copy_vector,
                  {isStore ? argument(*its) : slot, isStore ? slot : argument(*its)});
    else
      writer.call(global == ANYSL_P ? Op::linked_light_from : Op::linked_light_direction,
                  {slot, argument(Context), index});
  } else if (!storesVarying(op)) {
    return;
  }
  call.eraseFromParent();
}

/// The light as a function of the context, P, N, and of where L, Cl and Ol go.
Function *makeFunction(Function &body, unsigned number) {
  LLVMContext &context = body.getContext();
  SmallVector<Type *> types(ArgumentCount, PointerType::get(context, 0));
  Function *function = Function::Create(FunctionType::get(Type::getVoidTy(context), types, false),
                                        GlobalValue::InternalLinkage,
                                        "anysl.light." + Twine(number), *body.getParent());
  ValueToValueMapTy map;
  map[body.getArg(0)] = function->getArg(Context);
  SmallVector<ReturnInst *> returns;
  CloneFunctionInto(function, &body, map, CloneFunctionChangeType::LocalChangesOnly, returns);
  OperatorWriter writer(*body.getParent());
  Constant *index = ConstantInt::get(Type::getInt32Ty(context), number);
  for (Instruction &instruction : make_early_inc_range(instructions(function)))
    if (const stc::OpInfo *op = opOf(instruction))
      rewrite(cast<CallInst>(instruction), *op, *function, index, writer);
  // What a renderer puts there before it runs a light.
  BasicBlock &entry = function->getEntryBlock();
  auto isAlloc = [](const Instruction &instruction) {
    const stc::OpInfo *op = opOf(instruction);
    return op && op->purity == stc::Purity::Structural;
  };
  writer.before(*find_if_not(entry, isAlloc));
  writer.construct(function->getArg(L), stc::Type::vectorTy, {0, 0, 0});
  writer.construct(function->getArg(Cl), stc::Type::colorTy, {0, 0, 0});
  writer.construct(function->getArg(Ol), stc::Type::colorTy, {1, 1, 1});
  return function;
}

} // namespace

uint64_t codeOf(const Session &session, const stc::ShaderInfo &shader) {
  std::string text;
  raw_string_ostream stream(text);
  // The module's own name is that of a file, wherever it lies; metadata come in the context's
  // order.
  const Module &module = *shader.body->getParent();
  for (const GlobalVariable &variable : module.globals())
    variable.print(stream);
  ModuleSlotTracker slots(&module);
  slots.incorporateFunction(*shader.body);
  for (const BasicBlock &block : *shader.body) {
    stream << '\n';
    for (const Instruction &instruction : block) {
      std::string line;
      raw_string_ostream lineStream(line);
      instruction.print(lineStream, slots);
      stream << StringRef(line).split(", !").first << '\n';
    }
  }
  stream << session.real << '\n'
         << session.math.text() << '\n'
         << session.options.precision << ' ' << session.options.plainOperators;
  return xxh3_64bits(text);
}

bool readLightCode(Session &session) {
  const LinkOptions &options = session.options;
  // What notes what happens looks at lights by themselves.
  if ((session.real != "float" && session.real != "double") || !options.mathChoices.empty() ||
      options.checkNaN || options.traceOps || options.maxLoop || options.withoutEffects)
    return true;
  for (auto [number, light] : enumerate(linkedLights(session))) {
    if (light.values.light.kind != ANYSL_LIGHT_SHADER)
      continue;
    session.lightCode.resize(number + 1);
    std::string name = demand::shaderName(light.kind);
    for (const std::string &path : options.beside) {
      auto file = stc::readFile(session.diags, session.context, path);
      if (!file)
        return false;
      auto shader = find_if(file->shaders, [&](const stc::ShaderInfo &shader) {
        return shader.kind == stc::ShaderKind::Light && shader.name == name;
      });
      if (shader == file->shaders.end())
        continue;
      const uint64_t code = codeOf(session, *shader);
      std::vector<LightCell> cells = fixCells(session, *shader, light.parameters);
      decideBound(*shader->body);
      if (!fits(*shader->body))
        break;
      session.lightCode[number] = {makeFunction(*shader->body, unsigned(number)), code,
                                   std::move(cells)};
      // Nothing else of the file counts.
      for (Function &function : *file->module)
        if (!function.isDeclaration())
          function.setLinkage(GlobalValue::InternalLinkage);
      session.lightFiles.push_back(std::move(*file));
      break;
    }
  }
  return true;
}

void callLightCode(Session &session, Function &function) {
  OperatorWriter writer(*session.module);
  for (Instruction &instruction : make_early_inc_range(instructions(function))) {
    const stc::OpInfo *op = opOf(instruction);
    if (!op || op->op != Op::light_sample)
      continue;
    auto &call = cast<CallInst>(instruction);
    auto *index = dyn_cast<ConstantInt>(call.getArgOperand(1));
    if (!index || index->getZExtValue() >= session.lightCode.size())
      continue;
    LightCode &code = session.lightCode[index->getZExtValue()];
    if (!code.function)
      continue;
    writer.before(call);
    SmallVector<Value *> operands(call.args());
    Value *context = operands[0], *direction = operands[4], *color = operands[5];
    operands.erase(operands.begin() + 1); // the number
    writer.ir().CreateCall(code.function, operands);
    call.replaceAllUsesWith(
        writer.call(Op::linked_light_arrives, {context, index, direction, color}));
    call.eraseFromParent();
    code.isCalled = true;
  }
}

} // namespace anysl::link
