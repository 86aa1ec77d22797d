//===-- passes/Vectorize/Vectorize.cpp - whole-function vectorisation -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Vectorize.h"

#include "passes/Vectorize/CleanUp.h"
#include "passes/Vectorize/Flags.h"
#include "passes/Vectorize/MathTier.h"
#include "passes/Vectorize/Normalize.h"
#include "passes/Vectorize/PrivateArrays.h"
#include "passes/Vectorize/Stages.h"
#include "passes/Vectorize/Widener.h"

#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/VFABIDemangler.h"
#include "llvm/IR/Verifier.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Support/ErrorHandling.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Transforms/Utils/Cloning.h"

#include <deque>

using namespace llvm;

namespace anysl {

//===-- Attributes ----------------------------------------------------------===//

void addVectorVariant(Function &function, StringRef mangledName) {
  // An attribute of its own, as clang writes: LLVM's verifier refuses names such as
  // _ZGV_LLVM_N8v_f in "vector-function-abi-variant" unless another name follows in brackets.
  function.addFnAttr(mangledName);
}

void removeVectorVariants(Function &function) {
  function.removeFnAttr(VFABI::MappingsAttrName);
  SmallVector<std::string, 8> names;
  for (Attribute attribute : function.getAttributes().getFnAttrs())
    if (attribute.isStringAttribute() && attribute.getKindAsString().starts_with("_ZGV"))
      names.push_back(attribute.getKindAsString().str());
  for (const std::string &name : names)
    function.removeFnAttr(name);
}

void adoptVariantAnnotations(Module &module) {
  constexpr StringRef prefix = "anysl.vector_variant:";
  GlobalVariable *annotations = module.getGlobalVariable("llvm.global.annotations");
  if (!annotations || !annotations->hasInitializer())
    return;
  auto *list = dyn_cast<ConstantArray>(annotations->getInitializer());
  if (!list)
    return;
  SmallVector<Constant *, 8> kept;
  for (Value *entry : list->operands()) {
    auto *fields = dyn_cast<ConstantStruct>(entry);
    StringRef text;
    auto *function =
        fields ? dyn_cast<Function>(fields->getOperand(0)->stripPointerCasts()) : nullptr;
    auto *string =
        fields ? dyn_cast<GlobalVariable>(fields->getOperand(1)->stripPointerCasts()) : nullptr;
    if (function && string && string->hasInitializer())
      if (auto *data = dyn_cast<ConstantDataSequential>(string->getInitializer());
          data && data->isCString())
        text = data->getAsCString();
    if (function && text.consume_front(prefix)) {
      addVectorVariant(*function, text);
      // Both forms return in the end, which a call into a renderer does not tell by itself; knowing
      // it, LLVM moves what does not change from group to group before them and out of the loop.
      function->setWillReturn();
      if (std::optional<VariantName> name = parseVariantName(text))
        if (Function *variant = module.getFunction(name->functionName))
          variant->setWillReturn();
    } else {
      kept.push_back(cast<Constant>(entry));
    }
  }
  if (kept.size() == list->getNumOperands())
    return;
  std::string name = annotations->getName().str();
  if (!kept.empty()) {
    auto *type = ArrayType::get(list->getType()->getElementType(), kept.size());
    auto *shorter = new GlobalVariable(module, type, false, annotations->getLinkage(),
                                       ConstantArray::get(type, kept), "", annotations);
    shorter->setSection(annotations->getSection());
    shorter->takeName(annotations);
  }
  annotations->eraseFromParent();
}

void setVectorWidth(Function &function, unsigned bits) {
  auto raise = [&](StringRef attribute) {
    uint64_t present = 0;
    if (Attribute old = function.getFnAttribute(attribute); old.isValid())
      (void)old.getValueAsString().getAsInteger(10, present);
    function.addFnAttr(attribute, std::to_string(std::max<uint64_t>(present, bits)));
  };
  raise("min-legal-vector-width");
  // LLVM splits 512-bit vectors on processors that slow down for them, unless told otherwise.
  if (bits >= 512)
    raise("prefer-vector-width");
}

//===-- One variant ---------------------------------------------------------===//

namespace {

/// The bits of the widest vector in a type, be it a structure's, an array's or a function's.
unsigned widestVector(Type *type) {
  unsigned bits = 0;
  if (auto *vector = dyn_cast<FixedVectorType>(type))
    bits = vector->getNumElements() *
           (vector->getElementType()->isPointerTy() ? 64 : vector->getScalarSizeInBits());
  for (Type *part : type->subtypes())
    bits = std::max(bits, widestVector(part));
  return bits;
}

/// The same for what a function's calls pass and return.
unsigned widestPassed(const Function &function) {
  unsigned bits = 0;
  for (const Instruction &instruction : instructions(function))
    if (const auto *call = dyn_cast<CallBase>(&instruction); call && !isa<IntrinsicInst>(call))
      bits = std::max(bits, widestVector(call->getFunctionType()));
  return bits;
}

/// Makes the variants of a module one after the other; calls inside them ask for more.
class VariantMaker : public VariantProvider {
public:
  VariantMaker(Module &module, const VectorizeOptions &options, TargetMachine *targetMachine)
      : module(module), options(options), remarks(options), tier(module, options.mathFile),
        passes(targetMachine) {
    passes.registerModuleAnalyses(moduleAnalyses);
    passes.registerCGSCCAnalyses(sccAnalyses);
    passes.registerFunctionAnalyses(functionAnalyses);
    passes.registerLoopAnalyses(loopAnalyses);
    passes.crossRegisterProxies(loopAnalyses, functionAnalyses, sccAnalyses, moduleAnalyses);
  }

  bool run();
  Function *request(const Request &request, VariantName &name) override;

private:
  struct Job {
    Function *scalar;
    Function *wide;
    VariantName name;
    const Function *caller = nullptr; ///< for a variant that a call asked for
  };

  void ask(Function &scalar, const VariantName &name);
  bool make(const Job &job);
  Function *normalized(Function &scalar);
  void setAttributes(Function &wide, const Function &scalar, const VariantName &name,
                     const VariantSignature &signature, const Function *caller);
  void verify(const Function &function, StringRef stage);

  Module &module;
  const VectorizeOptions &options;
  Remarks remarks;
  MathTier tier;
  PassBuilder passes;
  LoopAnalysisManager loopAnalyses;
  FunctionAnalysisManager functionAnalyses;
  CGSCCAnalysisManager sccAnalyses;
  ModuleAnalysisManager moduleAnalyses;
  std::deque<Job> jobs;
  DenseMap<Function *, Function *> prepared;
  StringMap<VariantName> internalNames;
  DenseMap<Function *, unsigned> internalCount;
  bool changed = false;
};

} // namespace

void VariantMaker::verify(const Function &function, StringRef stage) {
#ifndef NDEBUG
  constexpr bool always = true;
#else
  constexpr bool always = false;
#endif
  if (!always && !options.verifyEach)
    return;
  std::string text;
  raw_string_ostream out(text);
  if (verifyFunction(function, &out))
    report_fatal_error(Twine("anysl-vectorize: ") + function.getName() + " is broken after " +
                       stage + ":\n" + text);
}

void VariantMaker::ask(Function &scalar, const VariantName &name) {
  if (options.width && options.width != name.width)
    return;
  std::string why = whyNotWidenable(scalar);
  auto signature = why.empty() ? VariantSignature::get(name, scalar.getFunctionType(),
                                                       module.getDataLayout(), why)
                               : std::nullopt;
  Function *wide = module.getFunction(name.functionName);
  if (wide && !wide->isDeclaration())
    return;
  if (signature && wide) {
    signature = VariantSignature::getFor(name, scalar.getFunctionType(), *wide, why);
  } else if (signature) {
    wide = Function::Create(signature->type(), scalar.getLinkage(), name.functionName, module);
    wide->setVisibility(scalar.getVisibility());
    wide->setDSOLocal(scalar.isDSOLocal());
  }
  if (!signature) {
    DebugLoc place;
    if (DISubprogram *subprogram = scalar.getSubprogram())
      place = DILocation::get(scalar.getContext(), subprogram->getLine(), 0, subprogram);
    remarks.emit(VectorizeRemark::Kind::Refused, scalar, place,
                 scalar.getName() + " has no variant " + name.functionName + ": " + why);
    return;
  }
  jobs.push_back({&scalar, wide, name});
}

Function *VariantMaker::request(const Request &request, VariantName &name) {
  if (!whyNotWidenable(*request.scalar).empty())
    return nullptr;
  name.isa = Isa::Llvm;
  name.masked = request.masked;
  name.width = request.width;
  name.params = request.params;
  name.scalarName = request.scalar->getName().str();
  // Each level of a recursion may have strides of its own; the general form serves them all.
  if (internalCount.lookup(request.scalar) >= 8)
    for (VariantParam &param : name.params)
      if (param.kind == VariantParam::Kind::Linear)
        param = VariantParam();
  std::string key;
  raw_string_ostream text(key);
  text << request.scalar->getName() << "." << (name.masked ? "M" : "N") << name.width;
  for (const VariantParam &param : name.params) {
    if (param.kind == VariantParam::Kind::Uniform)
      text << "u";
    else if (param.kind == VariantParam::Kind::Vector)
      text << "v";
    else
      text << "l" << (param.step < 0 ? "n" : "") << std::abs(param.step);
  }
  text << "." << int(request.isa);
  name.functionName = key;
  if (auto found = internalNames.find(key); found != internalNames.end()) {
    name = found->second;
    return module.getFunction(name.functionName);
  }
  std::string why;
  auto signature =
      VariantSignature::get(name, request.scalar->getFunctionType(), module.getDataLayout(), why);
  if (!signature)
    return nullptr;
  auto *wide = Function::Create(signature->type(), GlobalValue::InternalLinkage, key, module);
  name.functionName = wide->getName().str();
  internalNames[key] = name;
  ++internalCount[request.scalar];
  setAttributes(*wide, *request.scalar, name, *signature, request.caller);
  jobs.push_back({request.scalar, wide, name, request.caller});
  return wide;
}

Function *VariantMaker::normalized(Function &scalar) {
  Function *&copy = prepared[&scalar];
  if (copy)
    return copy;
  ValueToValueMapTy map;
  copy = CloneFunction(&scalar, map);
  copy->setName(scalar.getName() + ".normal");
  copy->setLinkage(GlobalValue::InternalLinkage);
  copy->setComdat(nullptr);
  if (tier.apply(*copy))
    verify(*copy, "taking functions from a math tier");
  if (options.keepFlags) {
    mindFlags(*copy);
    verify(*copy, "minding flags");
  }
  normalize(*copy, functionAnalyses, [&](StringRef step) { verify(*copy, step); });
  return copy;
}

void VariantMaker::setAttributes(Function &wide, const Function &scalar, const VariantName &name,
                                 const VariantSignature &signature, const Function *caller) {
  LLVMContext &context = module.getContext();
  AttrBuilder attributes(context, scalar.getAttributes().getFnAttrs());
  for (auto kind : {Attribute::OptimizeNone, Attribute::NoInline, Attribute::Speculatable,
                    Attribute::Memory, Attribute::AllocKind, Attribute::AllocSize})
    if (kind != Attribute::NoInline || scalar.hasFnAttribute(Attribute::OptimizeNone))
      attributes.removeAttribute(kind);
  wide.setAttributes(AttributeList::get(context, AttributeList::FunctionIndex, attributes));
  removeVectorVariants(wide);
  signature.addAttributes(wide);

  if (caller) {
    for (StringRef kind : {"target-cpu", "target-features", "tune-cpu", "prefer-vector-width",
                           "min-legal-vector-width"})
      if (Attribute attribute = caller->getFnAttribute(kind); attribute.isValid())
        wide.addFnAttr(attribute);
  } else if (StringRef features = featuresOf(name.isa); !features.empty()) {
    std::string list = scalar.getFnAttribute("target-features").getValueAsString().str();
    wide.addFnAttr("target-features", list.empty() ? features.str() : list + "," + features.str());
  }
  // LLVM takes AVX2's gathers for slow unless told otherwise, and loads lane by lane.
  if (StringRef list = wide.getFnAttribute("target-features").getValueAsString();
      list.contains("+avx2") && !list.contains("fast-gather"))
    wide.addFnAttr("target-features", (list + ",+fast-gather").str());
  unsigned bits = registerBits(name.isa, true);
  if (!bits) {
    bits = std::max<unsigned>(32 * name.width, widestVector(wide.getFunctionType()));
    bits = std::min(bits, 512u);
  }
  setVectorWidth(wide, bits);

  // Parameters that are passed on as they are keep what is known of them.
  unsigned next = wide.hasParamAttribute(0, Attribute::StructRet) ? 1 : 0;
  if (name.isa != Isa::Llvm && next == 0 && wide.arg_size() < scalar.arg_size())
    return;
  for (auto [i, param] : enumerate(name.params)) {
    if (next >= wide.arg_size())
      return;
    Type *type = wide.getFunctionType()->getParamType(next);
    Type *own = scalar.getFunctionType()->getParamType(i);
    if (param.kind == VariantParam::Kind::Vector) {
      // Skip all pieces of the vector.
      unsigned lanes =
          isa<FixedVectorType>(type) ? cast<FixedVectorType>(type)->getNumElements() : name.width;
      next += std::max(1u, name.width / lanes);
      continue;
    }
    if (type != own)
      return;
    AttrBuilder kept(context, scalar.getAttributes().getParamAttrs(i));
    kept.removeAttribute(Attribute::Returned);
    if (param.kind == VariantParam::Kind::Uniform && !name.masked) {
      wide.addParamAttrs(next++, kept);
      continue;
    }
    // What holds for the lanes that run need not hold for lane 0, or if none runs.
    AttrBuilder passing(context);
    for (auto kind : {Attribute::SExt, Attribute::ZExt, Attribute::InReg})
      if (kept.contains(kind))
        passing.addAttribute(kind);
    if (param.kind == VariantParam::Kind::Uniform) {
      for (auto kind : {Attribute::NoAlias, Attribute::NoCapture, Attribute::ReadOnly,
                        Attribute::ReadNone, Attribute::WriteOnly})
        if (kept.contains(kind))
          passing.addAttribute(kind);
      if (Type *byVal = kept.getByValType())
        passing.addByValAttr(byVal);
    }
    wide.addParamAttrs(next++, passing);
  }
}

bool VariantMaker::make(const Job &job) {
  Function &scalar = *job.scalar, &wide = *job.wide;
  std::string why;
  auto signature = VariantSignature::getFor(job.name, scalar.getFunctionType(), wide, why);
  if (!signature)
    return false;
  // A copy of its own, which takes its debug information along.
  ValueToValueMapTy map;
  Function *copy = CloneFunction(normalized(scalar), map);
  if (interleavePrivateArrays(*copy, job.name.width))
    verify(*copy, "laying out private arrays");
  {
    Analyses analyses(*copy, job.name, functionAnalyses);
    setAttributes(wide, scalar, job.name, *signature, job.caller);
    if (copy->hasFnAttribute(Attribute::StrictFP))
      wide.addFnAttr(Attribute::StrictFP);
    Widener(*copy, wide, job.name, *signature, analyses.loops, analyses.shapes, analyses.schedule,
            *this, remarks, scalar)
        .run();
  }
  // Where two functions disagree on whether a 512-bit register is there, one passes what the other
  // does not find.
  if (unsigned bits = widestPassed(wide))
    setVectorWidth(wide, std::min(bits, 512u));
  wide.setSubprogram(copy->getSubprogram());
  copy->setSubprogram(nullptr);
  functionAnalyses.clear(*copy, copy->getName());
  copy->eraseFromParent();
  verify(wide, "widening");
  if (options.cleanUp)
    cleanUp(wide, functionAnalyses, [&](StringRef step) { verify(wide, step); });
  DebugLoc place;
  if (DISubprogram *subprogram = scalar.getSubprogram())
    place = DILocation::get(scalar.getContext(), subprogram->getLine(), 0, subprogram);
  remarks.emit(VectorizeRemark::Kind::Widened, scalar, place,
               "widened to " + Twine(job.name.width) + " lanes as " + wide.getName());
  return true;
}

bool VariantMaker::run() {
  SmallVector<Function *, 16> functions;
  for (Function &function : module)
    if (!function.isDeclaration())
      functions.push_back(&function);
  for (Function *function : functions)
    for (const VariantName &name : variantNames(function->getAttributes()))
      ask(*function, name);
  while (!jobs.empty()) {
    Job job = jobs.front();
    jobs.pop_front();
    changed |= make(job);
  }
  for (auto [scalar, copy] : prepared) {
    functionAnalyses.clear(*copy, copy->getName());
    copy->eraseFromParent();
  }
  tier.removeUnused();
  return changed;
}

bool defineVectorVariants(Module &module, const VectorizeOptions &options,
                          TargetMachine *targetMachine) {
  return VariantMaker(module, options, targetMachine).run();
}

/// The machine of the module's triple, if the program that loads the plugin knows it. What each
/// function is compiled for stands in its attributes.
static std::unique_ptr<TargetMachine> machineOf(const Module &module) {
  std::string why;
  const Target *target = TargetRegistry::lookupTarget(module.getTargetTriple(), why);
  return std::unique_ptr<TargetMachine>(
      target ? target->createTargetMachine(module.getTargetTriple(), "", "", {}, {}) : nullptr);
}

PreservedAnalyses VectorizePass::run(Module &module, ModuleAnalysisManager &analyses) {
  std::unique_ptr<TargetMachine> own;
  if (!targetMachine)
    own = machineOf(module);
  return defineVectorVariants(module, options, own ? own.get() : targetMachine)
             ? PreservedAnalyses::none()
             : PreservedAnalyses::all();
}

} // namespace anysl
