//===-- lib/STC/Verifier.cpp - holds the rules of subroutine-threaded code ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Verifier.h"
#include "lib/STC/MetadataNames.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallVectorExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Verifier.h"

using namespace llvm;

namespace anysl::stc {
namespace {

bool isConstantText(const GlobalVariable &global) {
  if (!global.hasLocalLinkage() || !global.isConstant() || !global.hasInitializer())
    return false;
  const Constant *data = global.getInitializer();
  if (auto *array = dyn_cast<ConstantDataArray>(data))
    return array->isCString();
  // The empty text is folded to zeroinitializer.
  auto *type = dyn_cast<ArrayType>(data->getType());
  return isa<ConstantAggregateZero>(data) && type && type->getElementType()->isIntegerTy(8) &&
         type->getNumElements() == 1;
}

class ModuleVerifier {
public:
  explicit ModuleVerifier(const Module &module) : module(module) {}

  std::vector<Problem> run() {
    std::string message;
    raw_string_ostream stream(message);
    if (verifyModule(module, &stream)) {
      problem({}, "malformed LLVM code: " + StringRef(message).split('\n').first);
      return std::move(problems);
    }
    auto read = readShaders(module);
    if (!read) {
      problem({}, toString(read.takeError()));
      return std::move(problems);
    }
    shaders = std::move(*read);
    checkModule();
    for (const GlobalVariable &global : module.globals())
      checkGlobal(global);
    for (const Function &function : module)
      checkFunction(function);
    // Calls are judged by their callees' signatures, so those must be right first.
    if (problems.empty())
      for (const Function &function : module)
        checkBody(function);
    return std::move(problems);
  }

private:
  void problem(FilePosition position, const Twine &message) {
    problems.push_back({std::move(position), message.str()});
  }
  void problem(const Instruction &instruction, const Twine &message) {
    problem(positionOf(instruction), message);
  }

  void checkModule();
  void checkGlobal(const GlobalVariable &global);
  void checkFunction(const Function &function);
  void checkDefinition(const Function &function);
  void checkBody(const Function &function);
  void findShader(const Function &function);
  void checkInstruction(const Instruction &instruction);
  void checkCall(const CallInst &call);
  void checkOperand(const CallInst &call, StringRef callee, const OpParam &param,
                    const Value *operand);
  void checkStructural(const CallInst &call, const OpInfo &op);
  void checkArrays(const CallInst &call, const OpInfo &op);
  void checkIds(const CallInst &call, const OpInfo &op);
  void checkParameterUse(const CallInst &call, const OpInfo &op, IdKind kind, unsigned number);

  const Module &module;
  std::vector<ShaderInfo> shaders;
  std::vector<Problem> problems;

  // The function being checked.
  SmallVector<OpParam> signature;
  const ShaderInfo *shader = nullptr; ///< the shader whose body or init it is
  bool isInit = false;
};

void ModuleVerifier::checkModule() {
  if (!module.getTargetTriple().empty() || !module.getDataLayoutStr().empty())
    problem({}, "subroutine-threaded code names no target, but this module is for '" +
                    module.getTargetTriple() + "'");
  if (!module.getModuleInlineAsm().empty())
    problem({}, "inline assembly is not allowed");
  if (!module.alias_empty() || !module.ifunc_empty())
    problem({}, "aliases are not allowed");
}

void ModuleVerifier::checkGlobal(const GlobalVariable &global) {
  if (global.getName().starts_with(typeSymbolPrefix)) {
    if (!typeOfSymbol(&global))
      problem({}, "'" + global.getName() + "' names no type");
    else if (!global.isDeclaration() || !global.hasExternalLinkage() || global.isThreadLocal() ||
             !global.getValueType()->isIntegerTy(8) || global.getAddressSpace() != 0)
      problem({}, "'" + global.getName() + "' must be an external i8");
    return;
  }
  if (!isConstantText(global) || global.isThreadLocal() || global.hasSection() ||
      global.getAddressSpace() != 0)
    problem({}, "global variable '" + global.getName() +
                    "' is neither a type nor constant text of the module's own");
}

void ModuleVerifier::checkFunction(const Function &function) {
  StringRef name = function.getName();
  if (function.isIntrinsic()) {
    if (!isDbgInfoIntrinsic(function.getIntrinsicID()))
      problem({}, "function '" + name + "' is no operator");
    return;
  }
  if (!function.getAttributes().isEmpty() || function.getCallingConv() != CallingConv::C ||
      function.hasGC() || function.hasPersonalityFn() || function.hasPrefixData() ||
      function.hasPrologueData() || function.hasSection() || function.isVarArg())
    return problem({}, "function '" + name + "' has attributes, which are not allowed");

  const OpInfo *op = opOfSymbol(name);
  if (op && function.getFunctionType() != functionType(function.getContext(), *op))
    return problem({}, "operator '" + name + "' has a wrong signature");
  if (!function.isDeclaration())
    return checkDefinition(function);
  if (!op)
    problem({}, "function '" + name + "' is no operator");
  else if (!function.hasExternalLinkage())
    problem({}, "operator '" + name + "' must have external linkage");
}

/// Finds the shader whose body or init a function is.
void ModuleVerifier::findShader(const Function &function) {
  shader = nullptr;
  for (const ShaderInfo &candidate : shaders)
    if (&function == candidate.body || &function == candidate.init) {
      shader = &candidate;
      isInit = &function == candidate.init;
    }
}

void ModuleVerifier::checkDefinition(const Function &function) {
  StringRef name = function.getName();
  findShader(function);
  const OpInfo *op = opOfSymbol(name);
  if (op && op->purity == Purity::Structural)
    return problem({}, "operator '" + name + "' belongs to the linker and cannot be defined");
  if (op && !function.hasExternalLinkage())
    return problem({}, "operator '" + name + "' must have external linkage");
  if (!op && !shader && (!function.hasLocalLinkage() || !function.hasMetadata(metadata::signature)))
    return problem({}, "function '" + name +
                           "' is no operator, no shader's, and not an internal function with '!" +
                           metadata::signature + "'");
  auto declared = signatureOf(function);
  if (!declared || functionType(function.getContext(), ResultKind::None, *declared)->params() !=
                       function.getFunctionType()->params())
    return problem({}, "function '" + name + "' does not have the parameters that '!" +
                           metadata::signature + "' declares");
  llvm::Type *result = function.getReturnType();
  if (!result->isVoidTy() && !result->isIntegerTy(1) && !result->isIntegerTy(32))
    problem({}, "function '" + name + "' gives neither nothing nor a test nor an index");
}

void ModuleVerifier::checkBody(const Function &function) {
  if (function.isDeclaration())
    return;
  findShader(function);
  signature = *signatureOf(function);
  for (const Instruction &instruction : instructions(function))
    checkInstruction(instruction);
}

void ModuleVerifier::checkInstruction(const Instruction &instruction) {
  for (const Value *operand : instruction.operands())
    if (!isa<Instruction, Argument, BasicBlock, ConstantInt, ConstantFP, Function, GlobalVariable>(
            operand) &&
        !isa<MetadataAsValue>(operand))
      return problem(instruction, "an operand that is no variable, number, text or type");
  if (instruction.hasPoisonGeneratingFlags())
    return problem(instruction, "arithmetic with overflow flags is not allowed");

  llvm::Type *type = instruction.getType();
  switch (instruction.getOpcode()) {
  case Instruction::Call:
    if (!isa<DbgInfoIntrinsic>(instruction))
      checkCall(cast<CallInst>(instruction));
    return;
  case Instruction::Br:
    return;
  case Instruction::Ret:
    return;
  case Instruction::PHI:
    if (!type->isIntegerTy(1) && !type->isIntegerTy(32))
      problem(instruction, "only conditions and counters may be phis");
    return;
  case Instruction::And:
  case Instruction::Or:
  case Instruction::Xor:
    if (!type->isIntegerTy(1))
      problem(instruction, "bit operations are only for conditions");
    return;
  case Instruction::Add:
    if (!type->isIntegerTy(32))
      problem(instruction, "counters are i32");
    return;
  case Instruction::ICmp:
    if (!instruction.getOperand(0)->getType()->isIntegerTy(32))
      problem(instruction, "only counters are compared by LLVM's own instructions");
    return;
  default:
    problem(instruction,
            Twine("LLVM's '") + instruction.getOpcodeName() + "' is not allowed; use an operator");
  }
}

void ModuleVerifier::checkCall(const CallInst &call) {
  auto *callee = dyn_cast<Function>(call.getCalledOperand());
  if (!callee || callee->getFunctionType() != call.getFunctionType())
    return problem(call, "an indirect call");
  if (callee->isIntrinsic())
    return problem(call, "a call of '" + callee->getName() + "', which is no operator");
  if (call.hasOperandBundles() || !call.getAttributes().isEmpty() || call.isMustTailCall() ||
      call.getCallingConv() != CallingConv::C)
    return problem(call, "a call with attributes");
  if (!call.getDebugLoc())
    problem(call, "a call of '" + callee->getName() + "' without a debug location");

  const OpInfo *op = opOfSymbol(callee->getName());
  auto params = signatureOf(*callee);
  if (!op && (callee->isDeclaration() || callee->hasExternalLinkage()))
    return problem(call, "a call of '" + callee->getName() +
                             "', which is neither an operator nor a function of the module's own");
  if (!params || params->size() != call.arg_size())
    return problem(call, "a call of '" + callee->getName() + "', whose parameters are unknown");

  size_t before = problems.size();
  for (auto [param, operand] : zip(*params, call.args()))
    checkOperand(call, callee->getName(), param, operand);
  if (!op || problems.size() != before)
    return;
  checkStructural(call, *op);
  checkArrays(call, *op);
  checkIds(call, *op);
}

void ModuleVerifier::checkOperand(const CallInst &call, StringRef callee, const OpParam &param,
                                  const Value *operand) {
  auto refuse = [&](const Twine &reason) {
    problem(call, "an operand of '" + callee + "' " + reason);
  };
  switch (param.kind) {
  case ParamKind::In:
  case ParamKind::Out:
  case ParamKind::InOut:
  case ParamKind::Slot: {
    auto slot = slotInfo(operand);
    if (!slot)
      return refuse("is no variable");
    if (param.kind == ParamKind::Slot)
      return;
    if (!sameRepresentation(slot->type, param.type))
      return refuse("is a " + info(slot->type).name + ", not a " + info(param.type).name);
    if (slot->arrayLength != param.arrayLength)
      return refuse("is an array of another length");
    auto *argument = dyn_cast<Argument>(operand);
    if (argument && param.kind != ParamKind::In &&
        signature[argument->getArgNo()].kind == ParamKind::In)
      return refuse("is changed, but the function may only read it");
    return;
  }
  case ParamKind::Array: {
    auto slot = slotInfo(operand);
    if (!slot)
      return refuse("is no variable");
    if (slot->type != param.type)
      return refuse("is a " + info(slot->type).name + ", not a " + info(param.type).name);
    auto *argument = dyn_cast<Argument>(operand);
    if (argument && signature[argument->getArgNo()].kind == ParamKind::In)
      return refuse("is changed, but the function may only read it");
    return; // checkArrays() looks at the length behind it.
  }
  case ParamKind::Ctx: {
    auto *argument = dyn_cast<Argument>(operand);
    if (!argument || signature[argument->getArgNo()].kind != ParamKind::Ctx)
      return refuse("is not the context");
    return;
  }
  case ParamKind::Type:
    if (!typeOfSymbol(operand))
      return refuse("is no type");
    return;
  case ParamKind::Text: {
    auto *global = dyn_cast<GlobalVariable>(operand);
    if (!global || !isConstantText(*global))
      return refuse("is no constant text");
    return;
  }
  case ParamKind::Length:
  case ParamKind::Id:
    if (!isa<ConstantInt>(operand))
      return refuse("is no constant");
    return;
  case ParamKind::Number:
    if (!isa<ConstantFP>(operand))
      return refuse("is no constant");
    return;
  case ParamKind::Bool:
  case ParamKind::Index:
    return; // LLVM's verifier has compared the types.
  }
}

void ModuleVerifier::checkStructural(const CallInst &call, const OpInfo &op) {
  auto constant = [&](unsigned operand) {
    return cast<ConstantInt>(call.getArgOperand(operand))->getValue();
  };
  switch (op.op) {
  case Op::alloc:
  case Op::alloc_array:
    if (call.getParent() != &call.getFunction()->getEntryBlock())
      problem(call, "a variable is made outside the entry block");
    if (op.op == Op::alloc_array && (constant(1).ugt(maxArrayLength) || constant(1).isZero()))
      problem(call, "an array's length is not in [1, " + Twine(maxArrayLength) + "]");
    return;
  case Op::element: {
    auto array = slotInfo(call.getArgOperand(0));
    if (!array->arrayLength || array->arrayLength != constant(2) ||
        array->type != typeOfSymbol(call.getArgOperand(1)))
      problem(call, "'anysl_element' is not given its array's own type and length");
    return;
  }
  default:
    return;
  }
}

/// An operator is told how long an array is by the operand behind it. Of length 0 is any variable.
void ModuleVerifier::checkArrays(const CallInst &call, const OpInfo &op) {
  for (unsigned i = 0; i < op.params.size(); ++i) {
    if (op.params[i].kind != ParamKind::Array)
      continue;
    const APInt &length = cast<ConstantInt>(call.getArgOperand(i + 1))->getValue();
    if (!length.isZero() && length != slotInfo(call.getArgOperand(i))->arrayLength)
      problem(call, "an operand of '" + op.symbol() + "' is an array of another length");
  }
}

void ModuleVerifier::checkIds(const CallInst &call, const OpInfo &op) {
  if (shader && isInit && op.rule == Rule::Varying && op.takesContext())
    return problem(call, "'" + op.symbol() + "' needs a point, but defaults have none");
  auto kind = idKind(op);
  if (!kind)
    return;
  if (!shader && *kind != IdKind::Query)
    return problem(call, "'" + op.symbol() + "' outside a shader's own functions");

  // A number beyond 2^31 is as wrong as one just beyond the last.
  unsigned number = 0;
  for (auto [param, operand] : zip(op.params, call.args()))
    if (param.kind == ParamKind::Id)
      number = unsigned(cast<ConstantInt>(operand)->getValue().getLimitedValue(UINT32_MAX));

  if (*kind == IdKind::Query) {
    if (none_of(allQueryKinds(), [&](const QueryKind &entry) { return entry.id == number; }))
      problem(call, "there is no kind of query number " + Twine(number));
    return;
  }
  if (*kind != IdKind::Global)
    return checkParameterUse(call, op, *kind, number);
  const GlobalVariableInfo *global = globalNumbered(number);
  if (!global)
    return problem(call, "there is no shader global number " + Twine(number));
  bool writes = op.purity == Purity::Writes;
  bool named = any_of(shader->globals, [&](const GlobalInfo &entry) {
    return entry.id == number && (writes ? entry.written : entry.read);
  });
  if (!named)
    return problem(call, "the shader's metadata does not say that it " +
                             Twine(writes ? "writes '" : "reads '") + global->name + "'");
  for (const OpParam &param : op.params)
    if (param.isValue() && !sameRepresentation(param.type, global->type))
      problem(call, "shader global '" + global->name + "' is a " + info(global->type).name +
                        ", not a " + info(param.type).name);
}

void ModuleVerifier::checkParameterUse(const CallInst &call, const OpInfo &op, IdKind kind,
                                       unsigned number) {
  const ParamInfo *parameter = kind == IdKind::Cell             ? shader->paramOfCell(number)
                               : number < shader->params.size() ? &shader->params[number]
                                                                : nullptr;
  if (!parameter)
    return problem(call, Twine("there is no parameter ") +
                             (kind == IdKind::Cell ? "cell " : "number ") + Twine(number));
  for (const OpParam &param : op.params)
    if (param.isValue() && !sameRepresentation(param.type, parameter->type))
      return problem(call, "parameter '" + parameter->name + "' is a " +
                               info(parameter->type).name + ", not a " + info(param.type).name);
  if (kind == IdKind::Cell) {
    if ((number - parameter->firstCell) % info(parameter->type).components != 0)
      return problem(call, "cell " + Twine(number) + " lies within a value");
    if (op.purity == Purity::Writes && !isInit)
      return problem(call, "parameter '" + parameter->name + "' is set outside the defaults");
    return;
  }
  if (op.op == Op::param_is_set && !isInit)
    return problem(call, "'" + op.symbol() + "' outside the defaults");
  if (op.rule != Rule::Varying)
    return;
  if (parameter->storage != Storage::Varying && op.purity != Purity::Writes)
    return problem(call, "parameter '" + parameter->name + "' is not varying");
  if (op.purity == Purity::Writes && !parameter->output)
    return problem(call, "parameter '" + parameter->name + "' is no output");
  for (auto [param, operand] : zip(op.params, call.args()))
    if (param.kind == ParamKind::Length &&
        cast<ConstantInt>(operand)->getValue().uge(parameter->elementCount()))
      problem(call, "parameter '" + parameter->name + "' has no such element");
}

} // namespace

std::vector<Problem> verify(const Module &module) { return ModuleVerifier(module).run(); }

} // namespace anysl::stc
