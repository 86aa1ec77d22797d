//===-- passes/Vectorize/WidenCalls.cpp - widen calls -----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Intrinsics.h"
#include "passes/Vectorize/Widener.h"

#include "llvm/Analysis/ValueTracking.h"
#include "llvm/Analysis/VectorUtils.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl {

void Widener::widenCall(CallInst &call) {
  if (auto *intrinsic = dyn_cast<IntrinsicInst>(&call))
    if (widenIntrinsic(*intrinsic))
      return;
  if (shapeOf(&call).isUniform())
    return copyScalar(call);
  if (callVariant(call))
    return;
  Function *callee = call.getCalledFunction();
  if (!isHarmless(call) || callsMathLibrary(call))
    remark(VectorizeRemark::Kind::LaneByLane, call,
           Twine("calls ") + (callee ? callee->getName() : StringRef("through a pointer")) +
               " once per active lane, as it has no vector variant for " + Twine(width) + " lanes");
  replicate(call);
}

//===-- Intrinsics ----------------------------------------------------------===//

/// Whether llvm.fmuladd, which is one rounding or two as the processor likes, means the same in the
/// variant as in the scalar function: the letters d and e give the variant multiply-adds that the
/// scalar function may not have, and would change its results.
bool Widener::fusesLikeScalar() const {
  if (!featuresOf(name.isa).contains("+fma"))
    return true;
  StringRef features = reported.getFnAttribute("target-features").getValueAsString();
  return features.contains("+fma") || features.contains("+avx512f");
}

bool Widener::widenIntrinsic(IntrinsicInst &call) {
  Intrinsic::ID id = call.getIntrinsicID();
  switch (id) {
  // Hints about the scalar code, which would not hold for idle lanes or say nothing of vectors.
  case Intrinsic::assume:
  case Intrinsic::lifetime_start:
  case Intrinsic::lifetime_end:
  case Intrinsic::invariant_end:
  case Intrinsic::experimental_noalias_scope_decl:
  case Intrinsic::sideeffect:
  case Intrinsic::pseudoprobe:
  case Intrinsic::prefetch:
  case Intrinsic::donothing:
  case Intrinsic::var_annotation:
    return true;
  case Intrinsic::invariant_start:
    define(call, PoisonValue::get(call.getType()));
    return true;
  case Intrinsic::stacksave:
    // One stack for all lanes, however the result is declared to vary.
    define(call, broadcast(builder.CreateStackSave()));
    return true;
  case Intrinsic::stackrestore:
    builder.CreateStackRestore(
        builder.CreateExtractElement(vector(call.getArgOperand(0)), uint64_t(0)));
    return true;
  default:
    break;
  }
  if (isa<DbgInfoIntrinsic>(call))
    return true;
  if (id == Intrinsic::fmuladd && !call.getType()->isVectorTy() && !fusesLikeScalar()) {
    auto operand = [&](unsigned i) {
      Value *value = call.getArgOperand(i);
      return shapeOf(&call).isUniform() ? base(value) : vector(value);
    };
    Value *product = builder.CreateFMul(operand(0), operand(1));
    copyFlags(product, call);
    Value *sum = builder.CreateFAdd(product, operand(2));
    copyFlags(sum, call);
    define(call, sum);
    return true;
  }
  if (shapeOf(&call).isUniform())
    return false;
  switch (id) {
  case Intrinsic::expect:
  case Intrinsic::expect_with_probability:
  case Intrinsic::ssa_copy:
  case Intrinsic::annotation:
  case Intrinsic::ptr_annotation:
  case Intrinsic::launder_invariant_group:
  case Intrinsic::strip_invariant_group:
  case Intrinsic::arithmetic_fence:
    define(call, vector(call.getArgOperand(0)));
    return true;
  default:
    break;
  }

  if ((id == Intrinsic::fshl || id == Intrinsic::fshr) && shiftsThroughFloats())
    return false;
  if (auto *constrained = dyn_cast<ConstrainedFPIntrinsic>(&call))
    return widenConstrained(*constrained);
  if (!worksOnLanes(id) || call.getType()->isVectorTy() || callsMathLibrary(call))
    return false;
  SmallVector<Value *, 4> arguments;
  for (auto [i, argument] : enumerate(call.args())) {
    Value *operand = argument.get();
    bool scalarOperand =
        isVectorIntrinsicWithScalarOpAtArg(id, i) || call.paramHasAttr(i, Attribute::ImmArg);
    if (scalarOperand && !isa<Constant>(operand) && !shapeOf(operand).isUniform())
      return false;
    arguments.push_back(scalarOperand ? base(operand) : vector(operand));
  }
  CallInst *wideCall = callIntrinsic(builder, id, wide(call.getType()), arguments);
  if (!wideCall)
    return false;
  copyFlags(wideCall, call);
  define(call, wideCall);
  return true;
}

/// Arithmetic of a function that minds exception flags: idle lanes compute with one, which is exact
/// in all that can be done with it.
bool Widener::widenConstrained(ConstrainedFPIntrinsic &call) {
  Intrinsic::ID id = call.getIntrinsicID();
  if (call.getType()->isVectorTy() || !worksOnLanes(id))
    return false;
  SmallVector<Value *, 4> arguments, metadata;
  for (Value *operand : call.args()) {
    if (isa<MetadataAsValue>(operand)) {
      metadata.push_back(operand);
      continue;
    }
    Type *type = operand->getType();
    Value *lanes = vector(operand);
    if (!isFull()) {
      Constant *one = type->isIntegerTy() ? ConstantInt::get(type, 1) : ConstantFP::get(type, 1);
      lanes = builder.CreateSelect(currentMask(), lanes, broadcast(one));
    }
    arguments.push_back(lanes);
  }
  auto make = [&](Intrinsic::ID which, ArrayRef<Value *> operands) {
    SmallVector<Value *, 6> all(operands);
    all.append(metadata.begin(), metadata.end());
    CallInst *made = callIntrinsic(builder, which, wide(call.getType()), all);
    if (made) {
      made->addFnAttr(Attribute::StrictFP);
      copyFlags(made, call);
    }
    return made;
  };
  CallInst *made;
  if (id == Intrinsic::experimental_constrained_fmuladd && !fusesLikeScalar()) {
    made = make(Intrinsic::experimental_constrained_fmul, {arguments[0], arguments[1]});
    made = make(Intrinsic::experimental_constrained_fadd, {made, arguments[2]});
  } else {
    made = make(id, arguments);
  }
  if (!made)
    return false;
  define(call, made);
  return true;
}

//===-- Variants ------------------------------------------------------------===//

/// How well an instruction set fits a caller of another: the same, then LLVM's own, then smaller
/// ones.
static int preference(Isa callee, Isa caller) {
  if (callee == caller)
    return 8;
  if (callee == Isa::Llvm)
    return 7;
  if (caller == Isa::Llvm)
    return int(callee); // features are the function's; the richest comes first
  return callee < caller ? int(callee) : -1;
}

static bool hasFeatures(const Function &caller, Isa isa) {
  StringRef features = caller.getFnAttribute("target-features").getValueAsString();
  SmallVector<StringRef, 64> list;
  features.split(list, ',');
  auto has = [&](StringRef feature) { return is_contained(list, feature); };
  switch (isa) {
  case Isa::Sse:
  case Isa::Llvm:
    return true;
  case Isa::Avx:
    return has("+avx") || has("+avx2") || has("+avx512f");
  case Isa::Avx2:
    return has("+avx2") || has("+avx512f");
  case Isa::Avx512:
    return has("+avx512f");
  }
  return false;
}

/// Whether a shift of each lane by an amount of its own may raise an exception flag. Before AVX2
/// there is no such instruction, and LLVM makes powers of two from floating-point exponents, of
/// which 2^31 does not fit the integer that it is converted to.
bool Widener::shiftsThroughFloats() const {
  return widened.hasFnAttribute(Attribute::StrictFP) && !hasFeatures(widened, Isa::Avx2);
}

bool Widener::argumentsFit(CallInst &call, const VariantName &variant) {
  if (variant.params.size() != call.arg_size())
    return false;
  for (auto [param, operand] : zip(variant.params, call.args())) {
    Shape shape = shapeOf(operand);
    switch (param.kind) {
    case VariantParam::Kind::Vector:
      break;
    case VariantParam::Kind::Uniform:
      if (!shape.isUniform())
        return false;
      break;
    case VariantParam::Kind::Linear:
      if (!shape.isStrided() || shape.stride() != param.step)
        return false;
      break;
    case VariantParam::Kind::LinearByParam: {
      auto *step = dyn_cast<ConstantInt>(call.getArgOperand(param.step));
      if (!step || !shape.isStrided() || shape.stride() != step->getSExtValue())
        return false;
      break;
    }
    }
  }
  return true;
}

bool Widener::tryVariant(CallInst &call, const VariantName &variant, Function &callee) {
  std::string why;
  auto form = VariantSignature::getFor(variant, call.getFunctionType(), callee, why);
  if (!form) {
    remark(VectorizeRemark::Kind::LaneByLane, call, why);
    return false;
  }
  SmallVector<Value *, 8> arguments;
  for (auto [param, operand] : zip(variant.params, call.args()))
    arguments.push_back(param.kind == VariantParam::Kind::Vector ? vector(operand) : base(operand));
  if (variant.masked)
    arguments.push_back(currentMask());

  // Without a test a variant would run for nobody; one that cannot tell must not.
  BasicBlock *before = builder.GetInsertBlock(), *after = nullptr;
  if (!isOccupied()) {
    BasicBlock *inner = BasicBlock::Create(context, "call", &widened, before->getNextNode());
    after = BasicBlock::Create(context, "called", &widened, inner->getNextNode());
    builder.CreateCondBr(anyLane(currentMask()), inner, after);
    builder.SetInsertPoint(inner);
  }
  Value *result;
  CallInst *made = form->call(builder, &callee, arguments, result);
  made->setDebugLoc(call.getDebugLoc());
  if (call.doesNotThrow())
    made->setDoesNotThrow();
  if (after) {
    BasicBlock *end = builder.GetInsertBlock();
    builder.CreateBr(after);
    builder.SetInsertPoint(after);
    if (result) {
      PHINode *joined = builder.CreatePHI(result->getType(), 2);
      joined->addIncoming(PoisonValue::get(result->getType()), before);
      joined->addIncoming(result, end);
      result = joined;
    }
  }
  if (result)
    define(call, result);
  return true;
}

/// The function that a variant's name stands for, declared if need be; null if that cannot be.
Function *Widener::variantNamed(const VariantName &variant, Function &callee) {
  Module &module = *scalar.getParent();
  if (Function *known = module.getFunction(variant.functionName))
    return known;
  // Somebody else's: it is declared as the ABI says. LLVM's own names have no such promise, but
  // where the callee is defined here, its variants will be, too.
  std::string why;
  auto form = VariantSignature::get(variant, callee.getFunctionType(), layout, why);
  if (!form || (variant.isa == Isa::Llvm && callee.isDeclaration()))
    return nullptr;
  auto *declared =
      Function::Create(form->type(), GlobalValue::ExternalLinkage, variant.functionName, module);
  form->addAttributes(*declared);
  return declared;
}

/// Where there is a variant for all lanes only: calls it if all are active, and the scalar function
/// once per active lane otherwise.
bool Widener::callIfAllActive(CallInst &call, const VariantName &variant, Function &callee) {
  std::string why;
  auto form = VariantSignature::getFor(variant, call.getFunctionType(), callee, why);
  if (!form)
    return false;
  // Whatever either side uses comes from before the test.
  Value *mask = currentMask();
  SmallVector<Value *, 8> arguments;
  for (auto [param, operand] : zip(variant.params, call.args())) {
    Value *lanes = shapeOf(operand).isVarying() ? vector(operand) : base(operand);
    arguments.push_back(param.kind == VariantParam::Kind::Vector ? vector(operand) : lanes);
  }
  BasicBlock *all =
      BasicBlock::Create(context, "all", &widened, builder.GetInsertBlock()->getNextNode());
  BasicBlock *some = BasicBlock::Create(context, "some", &widened, all->getNextNode());
  BasicBlock *after = BasicBlock::Create(context, "called", &widened, some->getNextNode());
  Value *bits = builder.CreateBitCast(mask, builder.getIntNTy(width));
  builder.CreateCondBr(builder.CreateICmpEQ(bits, Constant::getAllOnesValue(bits->getType())), all,
                       some);
  builder.SetInsertPoint(all);
  Value *result;
  CallInst *made = form->call(builder, &callee, arguments, result);
  made->setDebugLoc(call.getDebugLoc());
  if (call.doesNotThrow())
    made->setDoesNotThrow();
  BasicBlock *allEnd = builder.GetInsertBlock();
  builder.CreateBr(after);

  builder.SetInsertPoint(some);
  remark(VectorizeRemark::Kind::LaneByLane, call,
         Twine("calls ") + call.getCalledFunction()->getName() +
             " once per active lane unless all are active, as it has no variant with a mask for " +
             Twine(width) + " lanes");
  replicate(call);
  BasicBlock *someEnd = builder.GetInsertBlock();
  builder.CreateBr(after);
  builder.SetInsertPoint(after);
  if (result) {
    PHINode *joined = builder.CreatePHI(result->getType(), 2);
    joined->addIncoming(result, allEnd);
    joined->addIncoming(definitions.lookup(&call), someEnd);
    define(call, joined);
  }
  return true;
}

/// Calls the best variant there is: one that the module or the callee's declaration names, else one
/// made from its body.
bool Widener::callVariant(CallInst &call) {
  Function *callee = call.getCalledFunction();
  if (!callee || callee->isIntrinsic() || call.hasOperandBundles() ||
      callee->getFunctionType() != call.getFunctionType())
    return false;

  struct Choice {
    VariantName name;
    int score;
  };
  SmallVector<Choice, 4> choices, forAll;
  auto consider = [&](const VariantName &variant) {
    if (variant.width != width || !argumentsFit(call, variant))
      return;
    int score = preference(variant.isa, name.isa);
    if (score < 0 || (name.isa == Isa::Llvm && !hasFeatures(widened, variant.isa)))
      return;
    // What is asked for besides the instruction set: no needless mask, few vectors.
    score = score * 64 + (isFull() != variant.masked ? 32 : 0);
    for (const VariantParam &param : variant.params)
      score += param.kind != VariantParam::Kind::Vector;
    (variant.masked || isFull() ? choices : forAll).push_back({variant, score});
  };
  for (const VariantName &variant : variantNames(call.getAttributes()))
    consider(variant);
  for (const VariantName &variant : variantNames(callee->getAttributes()))
    consider(variant);
  auto isBetter = [](const Choice &a, const Choice &b) { return a.score > b.score; };
  llvm::sort(choices, isBetter);
  llvm::sort(forAll, isBetter);

  for (const Choice &choice : choices)
    if (Function *variant = variantNamed(choice.name, *callee);
        variant && tryVariant(call, choice.name, *variant))
      return true;
  if (callee->isDeclaration() || callee->isInterposable()) {
    for (const Choice &choice : forAll)
      if (Function *variant = variantNamed(choice.name, *callee);
          variant && callIfAllActive(call, choice.name, *variant))
        return true;
    return false;
  }
  VariantProvider::Request request{callee, {}, !isFull(), width, name.isa, &widened};
  for (auto [i, operand] : enumerate(call.args())) {
    Shape shape = shapeOf(operand);
    VariantParam param;
    Type *type = operand->getType();
    if (shape.isUniform()) {
      param.kind = VariantParam::Kind::Uniform;
    } else if (shape.isStrided() &&
               (type->isPointerTy() || (shape.noSignedWrap() && shape.noUnsignedWrap()))) {
      param.kind = VariantParam::Kind::Linear;
      param.step = shape.stride();
    }
    // Memory that is passed by value, or returned into, is an address like any other to lanes; only
    // what the caller would have to copy is not.
    if (call.paramHasAttr(i, Attribute::ByVal) && param.kind != VariantParam::Kind::Uniform)
      return false;
    request.params.push_back(param);
  }
  VariantName made;
  Function *variant = provider.request(request, made);
  return variant && tryVariant(call, made, *variant);
}

} // namespace anysl
