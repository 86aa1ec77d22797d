//===-- lib/Link/SceneLights.cpp - lights that are linked into shaders --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Where a scene says which lights shine on every point, the standard runtimes get them as a table
// of constants (<anysl/standard/lights.h>), and loops over lights become one round after the other,
// each with its light's number as a constant: what a round does is decided by the light's kind, and
// the rounds of several loops share what they compute. Of a loop that has grown too long the table
// is all that is left. Whether a light is of a category is decided here, so that there is no round
// for one that is not.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/SceneLights.h"
#include "lib/Link/LightCode.h"
#include "lib/Link/Needs.h"
#include "lib/Link/SlotConstants.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/Analysis/AssumptionCache.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/Analysis/OptimizationRemarkEmitter.h"
#include "llvm/Analysis/ScalarEvolution.h"
#include "llvm/Analysis/TargetLibraryInfo.h"
#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Transforms/Utils/LoopSimplify.h"
#include "llvm/Transforms/Utils/LoopUtils.h"
#include "llvm/Transforms/Utils/UnrollLoop.h"

using namespace llvm;

namespace anysl::link {
namespace {

constexpr StringLiteral countVariable = "anysl_scene_light_count",
                        tableVariable = "anysl_scene_lights",
                        ambientVariable = "anysl_scene_ambient",
                        ambientKnownVariable = "anysl_scene_ambient_known";

/// How many instructions of threaded code the rounds of one loop may have together.
constexpr unsigned mostInstructions = 2000;

Constant *numbers(LLVMContext &context, ArrayRef<float> values) {
  return ConstantDataArray::get(context, values);
}

/// The loop whose rounds `count` counts: one that begins with i < count. Null if it is none.
Loop *loopOver(const Instruction &count, const LoopInfo &loops) {
  for (const User *user : count.users()) {
    auto *compare = dyn_cast<ICmpInst>(user);
    Loop *loop = compare ? loops.getLoopFor(compare->getParent()) : nullptr;
    if (loop && loop->getHeader() == compare->getParent() && !loop->contains(&count) &&
        compare->hasOneUse() && isa<BranchInst>(compare->user_back()))
      return loop;
  }
  return nullptr;
}

unsigned sizeOf(const Loop &loop) {
  unsigned result = 0;
  for (const BasicBlock *block : loop.blocks())
    result += unsigned(block->size());
  return result;
}

/// How much the lights bring along that are called in each loop.
unsigned sizeOfCode(const Session &session) {
  unsigned result = 0;
  for (const LightCode &light : session.lightCode)
    result += light.function ? light.function->getInstructionCount() : 0;
  return result;
}

/// Unrolls the loops over lights of one function, inner ones first, where the rounds with the
/// lights' code are not too long. Gives how many there were.
unsigned unroll(Function &function, unsigned lights, unsigned codeSize, const Session &session) {
  SmallVector<CallInst *> counts;
  for (Instruction &instruction : instructions(function))
    if (auto *call = dyn_cast<CallInst>(&instruction))
      if (const Function *callee = call->getCalledFunction();
          callee && callee->getName() == stc::info(stc::Op::light_count).symbol())
        counts.push_back(call);
  if (counts.empty())
    return 0;
  TargetLibraryInfoImpl libraryInfo{Triple(function.getParent()->getTargetTriple())};
  TargetLibraryInfo library(libraryInfo);
  TargetTransformInfo target = session.target.getTargetTransformInfo(function);
  AssumptionCache assumptions(function, &target);
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  OptimizationRemarkEmitter remarks(&function);
  SmallSetVector<Loop *, 4> found;
  for (CallInst *count : counts)
    if (Loop *loop = loopOver(*count, loops))
      found.insert(loop);
  for (CallInst *count : counts) {
    count->replaceAllUsesWith(ConstantInt::get(count->getType(), lights));
    count->eraseFromParent();
  }
  ScalarEvolution evolution(function, library, assumptions, dominators, loops);
  unsigned unrolled = 0;
  SmallVector<Loop *, 4> inOrder = loops.getLoopsInReverseSiblingPreorder();
  for (Loop *loop : reverse(inOrder)) {
    if (!found.contains(loop) || sizeOf(*loop) * lights + codeSize > mostInstructions)
      continue;
    simplifyLoop(loop, &dominators, &loops, &evolution, &assumptions, nullptr,
                 /*PreserveLCSSA=*/false);
    formLCSSARecursively(*loop, dominators, &loops, &evolution);
    // The last round only finds that there is no light left.
    UnrollLoopOptions options{};
    options.Count = lights + 1;
    options.Force = true;
    unrolled += UnrollLoop(loop, options, &loops, &evolution, &dominators, &assumptions, &target,
                           &remarks, /*PreserveLCSSA=*/true) == LoopUnrollResult::FullyUnrolled;
  }
  return unrolled;
}

/// Whether a light of these categories is one that light_in_category wants.
bool isInCategory(StringRef categories, StringRef wanted) {
  if (wanted.empty())
    return true;
  bool isNegative = wanted.consume_front("-");
  SmallVector<StringRef> own, names;
  categories.split(own, ',', -1, /*KeepEmpty=*/false);
  wanted.split(names, ',', -1, /*KeepEmpty=*/false);
  return any_of(own, [&](StringRef name) { return is_contained(names, name); }) != isNegative;
}

/// Decides which of the lights belong to categories that are constants.
void decideCategories(Function &function, ArrayRef<demand::LightDemand> lights,
                      const Session &session) {
  SmallVector<CallInst *> calls;
  for (Instruction &instruction : instructions(function))
    if (const stc::OpInfo *op = opOf(instruction); op && op->op == stc::Op::light_in_category)
      calls.push_back(cast<CallInst>(&instruction));
  if (calls.empty())
    return;
  const SlotConstants constants(function, session.real, nullptr);
  SmallVector<std::pair<CallInst *, bool>> decided;
  for (CallInst *call : calls) {
    auto *index = dyn_cast<ConstantInt>(call->getArgOperand(1));
    auto wanted = constants.before(*call, call->getArgOperand(2));
    if (!index || index->getZExtValue() >= lights.size() || !wanted)
      continue;
    const demand::LightDemand &light = lights[index->getZExtValue()];
    if (light.values.known & ANYSL_KNOWN_CATEGORY)
      decided.push_back({call, isInCategory(light.category, wanted->text)});
  }
  for (auto [call, belongs] : decided) {
    call->replaceAllUsesWith(ConstantInt::getBool(session.context, belongs));
    call->eraseFromParent();
  }
}

/// Displacements and lights are shaded without lights, methods at points of any shape.
bool areLit(const Session &session) {
  return all_of(session.shaders, [](const Shader &shader) {
    return shader.info.kind == stc::ShaderKind::Surface ||
           shader.info.kind == stc::ShaderKind::Volume;
  });
}

} // namespace

ArrayRef<demand::LightDemand> linkedLights(const Session &session) {
  if (!session.options.scene || !areLit(session))
    return {};
  auto lights = session.options.scene->linkedLights();
  return {lights.data(), lights.size()};
}

std::optional<std::array<float, 3>> linkedAmbient(const Session &session) {
  if (!session.options.scene || !areLit(session))
    return std::nullopt;
  return session.options.scene->ambient;
}

Constant *lightConstant(Module &module, const demand::LightDemand &demand) {
  LLVMContext &context = module.getContext();
  const AnyslLinkedLight &light = demand.values;
  Type *u32 = Type::getInt32Ty(context), *real = Type::getFloatTy(context);
  auto integer = [&](uint32_t value) { return ConstantInt::get(u32, value); };
  auto number = [&](float value) { return ConstantFP::get(real, double(value)); };
  Constant *none = ConstantPointerNull::get(PointerType::get(context, 0));
  Constant *category = none;
  if (!demand.category.empty()) {
    auto *text = ConstantDataArray::getString(context, demand.category);
    category = new GlobalVariable(module, text->getType(), /*isConstant=*/true,
                                  GlobalValue::PrivateLinkage, text, "anysl.category");
  }
  const AnyslLight &values = light.light;
  Constant *inner = ConstantStruct::getAnon(
      context, {integer(values.kind), integer(values.flags), numbers(context, values.color),
                numbers(context, values.from), numbers(context, values.direction),
                number(values.cos_outer), number(values.cos_inner), number(values.beam), category,
                none, none, none, ConstantInt::get(Type::getInt64Ty(context), values.code)});
  return ConstantStruct::getAnon(context,
                                 {inner, integer(light.known), integer(light.known_flags)});
}

void adaptLights(const Session &session, Module &runtime) {
  auto *ambient = runtime.getNamedGlobal(ambientVariable),
       *ambientKnown = runtime.getNamedGlobal(ambientKnownVariable);
  if (auto sum = linkedAmbient(session); sum && ambient && ambientKnown) {
    ambient->setInitializer(numbers(session.context, *sum));
    ambientKnown->setInitializer(ConstantInt::get(ambientKnown->getValueType(), 1));
    for (GlobalVariable *variable : {ambient, ambientKnown})
      variable->setLinkage(GlobalValue::ExternalLinkage);
  }
  auto lights = linkedLights(session);
  auto *count = runtime.getNamedGlobal(countVariable);
  auto *table = runtime.getNamedGlobal(tableVariable);
  if (!count || !table)
    return;
  auto *type = cast<ArrayType>(table->getValueType());
  auto *element = cast<StructType>(type->getElementType());
  SmallVector<Constant *> values;
  for (const demand::LightDemand &light : lights) {
    // The same as a value of the runtime's own types.
    Constant *value = lightConstant(runtime, light);
    auto fields = [](Constant *structure, unsigned field) {
      return structure->getAggregateElement(field);
    };
    SmallVector<Constant *> inner;
    for (unsigned i = 0; i < element->getElementType(0)->getStructNumElements(); ++i)
      inner.push_back(fields(fields(value, 0), i));
    values.push_back(ConstantStruct::get(
        element, {ConstantStruct::get(cast<StructType>(element->getElementType(0)), inner),
                  fields(value, 1), fields(value, 2)}));
  }
  values.resize(type->getNumElements(), Constant::getNullValue(element));
  table->setInitializer(ConstantArray::get(type, values));
  count->setInitializer(ConstantInt::get(count->getValueType(), lights.size()));
  for (GlobalVariable *variable : {count, table})
    variable->setLinkage(GlobalValue::ExternalLinkage);
}

bool unrollLights(Session &session) {
  session.linksAmbient =
      linkedAmbient(session) && session.module->getNamedGlobal(ambientKnownVariable);
  auto lights = linkedLights(session);
  // What does not look at lights serves any.
  if (lights.empty() || !session.module->getNamedGlobal(countVariable))
    return true;
  for (const demand::LightDemand &light : lights)
    session.report.linkedLights.push_back(light.kind);
  if (carriesDerivatives(*session.module))
    session.lightCode.clear(); // they go through a renderer without
  const unsigned codeSize = sizeOfCode(session);
  for (Function &function : *session.module) {
    session.report.lightLoops += unroll(function, unsigned(lights.size()), codeSize, session);
    decideCategories(function, lights, session);
    callLightCode(session, function);
  }
  for (auto [number, code] : enumerate(session.lightCode))
    if (code.isCalled)
      session.report.linkedLightCode.push_back(lights[number].kind);
  return true;
}

} // namespace anysl::link
