//===-- lib/Link/Notes.cpp - code that tells a host what happens to numbers ---------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Behind operators that a shader calls goes code that looks at operands and results and calls
// anysl_note of the runtime (<anysl/notes.h>). It looks at values through functions of the real
// (runtimes/real/operators/notes.cpp), so that it need not know what a number is. While nothing is
// to be noted this stage does nothing.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/NoteWriter.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;

namespace anysl::link {
namespace {

constexpr StringLiteral undecidedPrefix = "anysl_is_undecided_", lowName = "anysl_low_of_float";

bool isNumeric(const stc::OpParam &param) {
  return param.isValue() && param.type != stc::Type::stringTy;
}
bool isWritten(const stc::OpParam &param) { return param.kind != stc::ParamKind::In; }
bool isRead(const stc::OpParam &param) { return param.kind != stc::ParamKind::Out; }

/// The name under which the real has functions of a type: points and normals are vectors.
StringRef valueType(stc::Type type) {
  bool isTriple = type == stc::Type::pointTy || type == stc::Type::normalTy;
  return isTriple ? info(stc::Type::vectorTy).name : info(type).name;
}

/// Puts notes into one function.
class Noter {
public:
  Noter(Session &session, const Shader &shader, Function &function, Value *context)
      : session(session), shader(shader), builder(session.context),
        writer(session, shader, context) {
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallInst>(&instruction))
        if (Function *callee = call->getCalledFunction())
          if (const stc::OpInfo *op = stc::opOfSymbol(callee->getName()))
            calls.push_back({call, op});
  }

  void run() {
    for (auto [call, op] : calls) {
      if (session.options.checkNaN)
        noteNotFinite(*call, *op);
      if (session.notesBounds) {
        noteUndecided(*call, *op);
        noteBounds(*call, *op);
      }
      if (session.options.traceOps)
        traceOp(*call, *op);
    }
  }

private:
  using Values = SmallVector<Value *, 16>;

  CallInst *callReal(const Twine &name, ArrayRef<Value *> operands) {
    return builder.CreateCall(session.module->getFunction(name.str()), operands);
  }

  /// Appends the numbers of an operand.
  void addNumbers(Values &numbers, StringRef function, const stc::OpParam &param, Value *operand) {
    for (unsigned i = 0; i < info(param.type).components; ++i)
      numbers.push_back(callReal("anysl_" + function + "_of_" + valueType(param.type),
                                 {operand, builder.getInt32(i)}));
  }

  Value *isFinite(const stc::OpParam &param, Value *operand) {
    return callReal("anysl_is_finite_" + valueType(param.type), {operand});
  }

  /// An operator that makes what is not finite of what is.
  void noteNotFinite(CallInst &call, const stc::OpInfo &op) {
    if (none_of(op.params, [](auto &param) { return isNumeric(param) && isWritten(param); }))
      return;
    builder.SetInsertPoint(&call);
    Values operands, results;
    Value *bad = builder.getTrue();
    for (auto [i, param] : enumerate(op.params))
      if (isNumeric(param) && isRead(param)) {
        addNumbers(operands, "number", param, call.getArgOperand(i));
        bad = builder.CreateAnd(bad, isFinite(param, call.getArgOperand(i)));
      }
    builder.SetInsertPoint(call.getNextNode());
    builder.SetCurrentDebugLocation(call.getDebugLoc());
    Value *good = builder.getTrue();
    for (auto [i, param] : enumerate(op.params))
      if (isNumeric(param) && isWritten(param)) {
        addNumbers(results, "number", param, call.getArgOperand(i));
        good = builder.CreateAnd(good, isFinite(param, call.getArgOperand(i)));
      }
    noteIf(builder.CreateAnd(bad, builder.CreateNot(good)), call, ANYSL_NOTE_NOT_FINITE,
           nameOf(call, op), results, operands);
  }

  /// A condition, or an index, that bounds do not decide.
  void noteUndecided(CallInst &call, const stc::OpInfo &op) {
    Function *isUndecided = session.module->getFunction((undecidedPrefix + op.name).str());
    if (!isUndecided)
      return;
    builder.SetInsertPoint(call.getNextNode());
    builder.SetCurrentDebugLocation(call.getDebugLoc());
    Values operands, pointers;
    for (auto [i, param] : enumerate(op.params)) {
      pointers.push_back(call.getArgOperand(i));
      addNumbers(operands, "number", param, call.getArgOperand(i));
    }
    Value *result = builder.CreateUIToFP(&call, builder.getDoubleTy());
    noteIf(builder.CreateCall(isUndecided, pointers), call, ANYSL_NOTE_UNDECIDED, op.name, {result},
           operands);
  }

  /// Whether an operator hands its last operand, which consists of numbers, to the host.
  static bool isStore(const stc::OpInfo &op) {
    return op.purity == stc::Purity::Writes && stc::idKind(op) && !op.params.empty() &&
           isNumeric(op.params.back()) && op.params.back().type != stc::Type::matrixTy;
  }

  /// The bounds of what goes to the host.
  void noteBounds(CallInst &call, const stc::OpInfo &op) {
    if (!isStore(op))
      return;
    const stc::OpParam &stored = op.params.back();
    builder.SetInsertPoint(&call);
    Values low, high;
    addNumbers(low, "low", stored, call.getArgOperand(call.arg_size() - 1));
    addNumbers(high, "high", stored, call.getArgOperand(call.arg_size() - 1));
    note(call, ANYSL_NOTE_BOUNDS, nameOf(call, op), low, high);
  }

  /// What an operator does, and with which values, each named by its address.
  void traceOp(CallInst &call, const stc::OpInfo &op) {
    if (op.purity == stc::Purity::Structural)
      return;
    builder.SetInsertPoint(call.getNextNode());
    builder.SetCurrentDebugLocation(call.getDebugLoc());
    auto address = [&](Value *operand) {
      return builder.CreateUIToFP(builder.CreatePtrToInt(operand, builder.getInt64Ty()),
                                  builder.getDoubleTy());
    };
    Values read;
    for (auto [i, param] : enumerate(op.params))
      if (isNumeric(param) && isRead(param))
        read.push_back(address(call.getArgOperand(i)));
    for (auto [i, param] : enumerate(op.params)) {
      if (!isNumeric(param) || !isWritten(param))
        continue;
      Values numbers, addresses = {address(call.getArgOperand(i))};
      addresses.append(read);
      addNumbers(numbers, "number", param, call.getArgOperand(i));
      note(call, ANYSL_NOTE_VALUE, op.name, numbers, addresses);
    }
    if (op.result == stc::ResultKind::Test)
      note(call, ANYSL_NOTE_DECISION, op.name, {builder.CreateUIToFP(&call, builder.getDoubleTy())},
           read);
    if (op.result == stc::ResultKind::Index)
      note(call, ANYSL_NOTE_DECISION, op.name, {builder.CreateSIToFP(&call, builder.getDoubleTy())},
           read);
    if (isStore(op)) {
      Values numbers;
      addNumbers(numbers, "number", op.params.back(), call.getArgOperand(call.arg_size() - 1));
      note(call, ANYSL_NOTE_STORE, nameOf(call, op), numbers, {read.back()});
    }
  }

  /// What an operator is called: by its name, or by that of the global or parameter it is about.
  std::string nameOf(const CallInst &call, const stc::OpInfo &op) const {
    auto kind = stc::idKind(op);
    auto place = find_if(op.params, [](auto &param) { return param.kind == stc::ParamKind::Id; });
    if (!kind || place == op.params.end())
      return op.name.str();
    auto id = unsigned(
        cast<ConstantInt>(call.getArgOperand(unsigned(place - op.params.begin())))->getZExtValue());
    if (*kind == stc::IdKind::Global)
      if (const stc::GlobalVariableInfo *global = stc::globalNumbered(id))
        return global->name.str();
    if (*kind == stc::IdKind::Param && id < shader.info.params.size())
      return shader.info.params[id].name;
    if (*kind == stc::IdKind::Cell)
      if (const stc::ParamInfo *param = shader.info.paramOfCell(id))
        return param->name;
    return op.name.str();
  }

  void noteIf(Value *condition, CallInst &call, uint32_t kind, StringRef name,
              ArrayRef<Value *> results, ArrayRef<Value *> operands) {
    Instruction *then =
        SplitBlockAndInsertIfThen(condition, builder.GetInsertPoint(), /*Unreachable=*/false);
    builder.SetInsertPoint(then);
    builder.SetCurrentDebugLocation(call.getDebugLoc());
    note(call, kind, name, results, operands);
  }

  void note(CallInst &call, uint32_t kind, StringRef name, ArrayRef<Value *> results,
            ArrayRef<Value *> operands) {
    writer.write(builder, stc::positionOf(call), kind, name, results, operands);
  }

  Session &session;
  const Shader &shader;
  IRBuilder<> builder;
  NoteWriter writer;
  SmallVector<std::pair<CallInst *, const stc::OpInfo *>> calls;
};

} // namespace

std::vector<std::string> noteSymbols(const Session &session) {
  std::vector<std::string> result;
  if (!session.options.checkNaN && !session.options.traceOps && !session.notesBounds &&
      !session.options.maxLoop)
    return result;
  result.push_back(noteName.str());
  for (StringRef type : {"float", "color", "vector", "matrix"}) {
    result.push_back(("anysl_number_of_" + type).str());
    if (session.options.checkNaN)
      result.push_back(("anysl_is_finite_" + type).str());
    if (session.notesBounds && type != "matrix")
      for (StringRef bound : {"low", "high"})
        result.push_back(("anysl_" + bound + "_of_" + type).str());
  }
  if (session.notesBounds)
    for (const stc::OpInfo &op : stc::allOps())
      if (any_of(session.layers, [&](const Layer &layer) {
            return layer.module->getFunction((undecidedPrefix + op.name).str());
          }))
        result.push_back((undecidedPrefix + op.name).str());
  return result;
}

bool hasBounds(const Module &real) { return real.getFunction(lowName); }

bool addNotes(Session &session) {
  if (!session.module->getFunction(noteName))
    return true;
  for (Shader &shader : session.shaders)
    forEachWithContext(shader, [&](Function &function, Value *context) {
      Noter(session, shader, function, context).run();
    });
  return true;
}

} // namespace anysl::link
