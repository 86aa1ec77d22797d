//===-- frontends/rsl/Lower.cpp - shaders and library functions -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lower.h"
#include "frontends/rsl/Frontend.h"
#include "frontends/rsl/Lowering.h"
#include "llvm/IR/CFG.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

std::unique_ptr<Module> lower(const Ast &ast, DiagnosticEngine &diags, LLVMContext &context,
                              StringRef sourceFile, const FrontendOptions &options) {
  Lowering lowering(diags, context, sourceFile, options.debugInfo);
  if (options.isLibrary) {
    for (const FunctionDecl *function : ast.functions)
      if (function->defines)
        lowering.lowerLibraryFunction(*function);
  } else {
    for (const ShaderDecl *shader : ast.shaders)
      lowering.lowerShader(*shader);
  }
  std::unique_ptr<Module> module = lowering.finish();
  return diags.hasErrors() ? nullptr : std::move(module);
}

Lowering::Lowering(DiagnosticEngine &diags, LLVMContext &context, StringRef sourceFile,
                   bool debugInfo)
    : diags(diags), b(context, sourceFile, "rslc " ANYSL_VERSION, debugInfo) {}

/// What is written from here on stands at this place of the source.
void Lowering::at(SMLoc loc) {
  if (!loc.isValid() || loc == lastLocation)
    return;
  lastLocation = loc;
  FilePosition position = diags.presumed(loc);
  b.setLocation(position.file, position.line, position.column);
}

//===-- Variables that live outside of functions ------------------------------------------------//

Value *Lowering::globalSlot(unsigned id) {
  if (auto light = lightGlobals.find(id); light != lightGlobals.end())
    return light->second;
  Value *&slot = globals[id];
  if (!slot) {
    const stc::GlobalVariableInfo &info = *stc::globalNumbered(id);
    slot = b.alloc(info.type, info.name, info.storage);
  }
  return slot;
}

Value *Lowering::globalSlot(const VarDecl &global) { return globalSlot(global.id); }

/// A parameter's slot in the body; where defaults are computed, its value at this moment.
Value *Lowering::paramSlot(const VarDecl &param) {
  bool isFirst = !slots.count(&param);
  if (initOf || isFirst) {
    stc::Type type = lowered(param.type.kind);
    slots[&param] = param.type.isArray() ? b.allocArray(type, unsigned(param.type.length),
                                                        param.name, storage(param.type))
                                         : b.alloc(type, param.name, storage(param.type));
    if (param.lengthVariable)
      lengths[slots[&param]] = paramSlot(*param.lengthVariable);
  }
  Value *slot = slots[&param];
  if (initOf)
    loadUniformParam(initOf->params[param.id], slot);
  usedParams.insert(&param);
  return slot;
}

Value *Lowering::slotOf(const VarDecl &decl) {
  switch (decl.kind) {
  case VarKind::Global:
    return globalSlot(decl);
  case VarKind::ShaderParam:
    return paramSlot(decl);
  case VarKind::FunctionParam:
  case VarKind::Local:
    break;
  }
  Value *slot = slots.lookup(&decl);
  if (!slot && decl.isHidden)
    slot = slots[&decl] = temporary(decl.type, decl.name);
  assert(slot && "a variable is declared before it is used");
  return slot;
}

void Lowering::loadUniformParam(const stc::ParamInfo &info, Value *slot) {
  static constexpr Op loads[] = {
      Op::load_param_float,  Op::load_param_color,  Op::load_param_vector, Op::load_param_vector,
      Op::load_param_vector, Op::load_param_matrix, Op::load_param_string};
  Op load = loads[unsigned(info.type) - 1];
  unsigned components = stc::info(info.type).components;
  for (unsigned i = 0; i < info.elementCount(); ++i)
    b.call(load, {info.arrayLength ? elementOf(slot, i) : slot, b.context(),
                  b.id(info.firstCell + i * components)});
}

/// A varying parameter comes point by point where the host has bound it, else from its cells, or
/// from a default that differs from point to point.
void Lowering::loadParam(const VarDecl &param, const stc::ParamInfo &info, Value *slot) {
  // Texts are never given point by point.
  if (info.storage == stc::Storage::Uniform || info.type == stc::Type::stringTy)
    return loadUniformParam(info, slot);
  Value *isBound = b.call(Op::param_is_bound, {b.context(), b.id(param.id)});
  BasicBlock *bound = b.block("bound"), *unbound = b.block("unbound"), *join = b.block("loaded");
  branchIf(isBound, bound, unbound);
  continueIn(bound);
  Op load = param.type.kind == TypeKind::Matrix
                ? Op::load_varying_matrix
                : opFor(param.type.kind, Op::load_varying_float, Op::load_varying_color,
                        Op::load_varying_vector);
  for (unsigned i = 0; i < info.elementCount(); ++i)
    b.call(load, {info.arrayLength ? elementOf(slot, i) : slot, b.context(), b.id(param.id),
                  b.length(i)});
  branchTo(join);
  continueIn(unbound);
  if (!param.defaultVaries)
    loadUniformParam(info, slot);
  else if (auto *list = dyn_cast<ListExpr>(param.init))
    lowerListInto(*list, slot);
  else
    copy(param.type, slot, lower(param.init));
  branchTo(join);
  continueIn(join);
}

void Lowering::loadUsedParams(const ShaderDecl &shader, const stc::ShaderInfo &info) {
  // A default that is computed here may name any earlier parameter.
  bool wantsEarlier = false;
  for (const VarDecl *param : llvm::reverse(shader.params)) {
    bool isUsed = usedParams.count(param) || wantsEarlier;
    if (!isUsed)
      continue;
    paramSlot(*param);
    wantsEarlier |= param->defaultVaries && param->type.varying;
  }
  for (const VarDecl *param : shader.params)
    if (usedParams.count(param)) {
      at(param->range.Start);
      loadParam(*param, info.params[param->id], slots[param]);
    }
}

void Lowering::storeOutputs(const ShaderDecl &shader, const stc::ShaderInfo &info) {
  for (unsigned id : writtenGlobals) {
    const stc::GlobalVariableInfo &global = *stc::globalNumbered(id);
    Op store = opFor(typeKindOf(global.type), Op::store_global_float, Op::store_global_color,
                     Op::store_global_vector);
    b.call(store, {b.context(), b.id(id), globalSlot(id)});
  }
  for (const VarDecl *param : shader.params) {
    if (!param->isOutput)
      continue;
    Op store = param->type.kind == TypeKind::Matrix ? Op::store_varying_matrix
               : param->type.kind == TypeKind::String
                   ? Op::store_varying_string
                   : opFor(param->type.kind, Op::store_varying_float, Op::store_varying_color,
                           Op::store_varying_vector);
    Value *slot = paramSlot(*param);
    for (unsigned i = 0; i < info.params[param->id].elementCount(); ++i)
      b.call(store, {b.context(), b.id(param->id), b.length(i),
                     param->type.isArray() ? elementOf(slot, i) : slot});
  }
}

void Lowering::loadGlobal(unsigned id, Value *slot) {
  const stc::GlobalVariableInfo &global = *stc::globalNumbered(id);
  b.call(opFor(typeKindOf(global.type), Op::load_global_float, Op::load_global_color,
               Op::load_global_vector),
         {slot, b.context(), b.id(id)});
}

//===-- Shaders ---------------------------------------------------------------------------------//

/// Code behind a return goes, and so do branches from one block to the next.
static void tidy(Function &function) {
  EliminateUnreachableBlocks(function);
  for (BasicBlock &block : llvm::make_early_inc_range(function))
    MergeBlockIntoPredecessor(&block);
}

void Lowering::beginBody() {
  slots.clear();
  lengths.clear();
  globals.clear();
  lightGlobals.clear();
  writtenGlobals.clear();
  usedParams.clear();
  loops.clear();
  currentLight = {};
  resultSlot = nullptr;
  resultType = {TypeKind::Void};
  exitBlock = returnBlock = nullptr;
  bodyBlock = b.block("body");
  continueIn(bodyBlock);
}

/// Whether some way through the function may look at a slot's value before giving it one. A
/// look-out that is an operator's own pointer argument counts as written by the caller.
bool Lowering::mayReadBeforeWrite(Value *slot) {
  SmallPtrSet<BasicBlock *, 32> seen;
  SmallVector<BasicBlock *, 16> open{bodyBlock};
  while (!open.empty()) {
    BasicBlock *block = open.pop_back_val();
    if (!seen.insert(block).second)
      continue;
    bool written = false;
    for (Instruction &instruction : *block) {
      auto *call = dyn_cast<CallInst>(&instruction);
      if (!call || !is_contained(call->args(), slot))
        continue;
      const stc::OpInfo *op = stc::opOfSymbol(call->getCalledFunction()->getName());
      for (unsigned i = 0; i < call->arg_size(); ++i)
        if (call->getArgOperand(i) == slot && (!op || op->params[i].kind != stc::ParamKind::Out))
          return true;
      written = true;
      break;
    }
    if (!written)
      llvm::append_range(open, successors(block));
  }
  return false;
}

void Lowering::lowerShader(const ShaderDecl &shader) {
  stc::ShaderInfo info;
  info.name = shader.name.str();
  shaderName = shader.name;
  shaderType = shader.type;
  info.kind = static_cast<stc::ShaderKind>(shader.type);
  unsigned cell = 0;
  for (const VarDecl *param : shader.params) {
    stc::ParamInfo entry;
    entry.name = param->name.str();
    entry.type = lowered(param->type.kind);
    entry.storage = storage(param->type);
    entry.output = param->isOutput;
    entry.arrayLength = param->type.isArray() ? unsigned(param->type.length) : 0;
    entry.firstCell = cell;
    cell += entry.cellCount();
    info.params.push_back(entry);
  }
  if (cell > stc::maxCells) {
    diags.error(shader.range.Start, "the parameters of '" + shader.name + "' take too much space");
    return;
  }
  at(shader.range.Start);
  // The shaders that a class is share its name, not their code's.
  std::string symbol = shader.name.str();
  if (b.module().getFunction(symbol))
    symbol += "." + nameOf(shader.type).str();
  info.body = b.beginFunction(symbol);
  beginBody();
  for (const VarDecl *param : shader.params)
    if (param->isOutput)
      paramSlot(*param);
  exitBlock = b.block("exit");
  returnBlock = exitBlock;
  lowerBody(*shader.body);
  at(shader.body->end);
  if (shader.method)
    lowerMethod(*shader.method);
  branchTo(exitBlock);
  continueIn(exitBlock);
  if (shader.type == ShaderType::Light)
    finishLight();
  exitBlock = builder().GetInsertBlock();
  storeOutputs(shader, info);
  builder().CreateRetVoid();

  // What the body turned out to use is loaded in front of it.
  BasicBlock *paramBlock = b.block("params");
  paramBlock->moveBefore(bodyBlock);
  builder().SetInsertPoint(paramBlock);
  at(shader.range.Start);
  loadUsedParams(shader, info);
  at(shader.range.Start);
  branchTo(bodyBlock);
  while (&info.body->back() != exitBlock) // blocks of varying parameters
    info.body->back().moveAfter(paramBlock);
  bodyBlock = paramBlock;
  continueIn(&info.body->getEntryBlock());
  for (auto [id, slot] : globals) {
    bool isRead = mayReadBeforeWrite(slot);
    bool isWritten = writtenGlobals.count(id);
    if (isRead && shader.type == ShaderType::Light && startLightResult(id, slot))
      isRead = false;
    info.globals.push_back({id, isRead, isWritten});
    if (isRead)
      loadGlobal(id, slot);
  }
  branchTo(paramBlock);
  tidy(*info.body);

  lowerInit(shader, info);
  b.addShader(info);
}

void Lowering::lowerInit(const ShaderDecl &shader, stc::ShaderInfo &info) {
  lastLocation = SMLoc();
  at(shader.range.Start);
  info.init = b.beginFunction(info.body->getName().str() + ".init");
  beginBody();
  initOf = &info;
  static constexpr Op stores[] = {Op::store_param_float,  Op::store_param_color,
                                  Op::store_param_vector, Op::store_param_vector,
                                  Op::store_param_vector, Op::store_param_matrix,
                                  Op::store_param_string};
  for (const VarDecl *param : shader.params) {
    if (param->defaultVaries)
      continue;
    const stc::ParamInfo &entry = info.params[param->id];
    at(param->range.Start);
    Value *isSet = b.call(Op::param_is_set, {b.context(), b.id(param->id)});
    BasicBlock *compute = b.block("default"), *next = b.block("next");
    branchIf(isSet, next, compute);
    continueIn(compute);
    Type type = param->type.withVarying(false);
    Value *value;
    if (!param->init) {
      value = zero(type);
    } else if (auto *list = dyn_cast<ListExpr>(param->init)) {
      value = temporary(type, param->name);
      lowerListInto(*list, value);
    } else {
      value = lower(param->init);
    }
    at(param->range.Start);
    unsigned components = stc::info(entry.type).components;
    for (unsigned i = 0; i < entry.elementCount(); ++i)
      b.call(stores[unsigned(entry.type) - 1], {b.context(), b.id(entry.firstCell + i * components),
                                                entry.arrayLength ? elementOf(value, i) : value});
    branchTo(next);
    continueIn(next);
  }
  at(shader.range.Start);
  builder().CreateRetVoid();
  continueIn(&info.init->getEntryBlock());
  for (auto [id, slot] : globals) {
    loadGlobal(id, slot);
  }
  branchTo(bodyBlock);
  initOf = nullptr;
  tidy(*info.init);
}

//===-- The shading library ---------------------------------------------------------------------//

/// The operator's pointer arguments are the function's variables, except those that the body
/// assigns: they are written back at the end, so that a caller may hand over one slot twice.
void Lowering::lowerLibraryFunction(const FunctionDecl &function) {
  const Builtin &builtin = *function.defines;
  const stc::OpInfo &op = stc::info(builtin.op);
  lastLocation = SMLoc();
  at(function.range.Start);
  Function *definition = b.beginOperator(builtin.op);
  beginBody();
  Value *result = nullptr;
  std::vector<std::pair<const VarDecl *, Value *>> outputs;
  size_t nextOperand = 0, nextParam = 0;
  for (unsigned i = 0; i < op.params.size(); ++i) {
    Argument *argument = definition->getArg(i);
    if (op.params[i].kind == stc::ParamKind::Ctx)
      continue;
    if (!result && builtin.result != TypeKind::Void) {
      result = argument;
      argument->setName("result");
      continue;
    }
    const BuiltinOperand &operand = builtin.operands[nextOperand++];
    if (operand.source == BuiltinOperand::Global) {
      globals[unsigned(operand.global)] = argument;
      argument->setName(stc::globalNumbered(unsigned(operand.global))->name);
      continue;
    }
    const VarDecl *param = function.params[nextParam++];
    argument->setName(param->name);
    slots[param] = argument;
    if (!param->isOutput && !param->isCopied)
      continue;
    Value *local = temporary(param->type, param->name);
    if (operand.source == BuiltinOperand::Out)
      setZero(param->type, local);
    else
      copy(param->type, local, argument);
    slots[param] = local;
    if (param->isOutput)
      outputs.push_back({param, argument});
  }
  resultType = {function.result.kind, true};
  if (result) {
    resultSlot = temporary(resultType, "value");
    if (!alwaysReturns(function.body))
      setZero(resultType, resultSlot);
  }
  exitBlock = returnBlock = b.block("exit");
  lowerBody(*function.body);
  at(function.body->end);
  branchTo(exitBlock);
  continueIn(exitBlock);
  for (auto [param, argument] : outputs)
    copy(param->type, argument, slots[param]);
  if (result)
    copy(resultType, result, resultSlot);
  builder().CreateRetVoid();

  continueIn(&definition->getEntryBlock());
  for (auto [id, slot] : globals) {
    const stc::GlobalVariableInfo &global = *stc::globalNumbered(id);
    if (writtenGlobals.count(id))
      diags.error(function.range.Start, "a library function cannot assign '" + global.name + "'");
    if (!isa<Argument>(slot))
      diags.error(function.range.Start,
                  "'" + global.name + "' is no operand of operator '" + op.name + "'");
  }
  branchTo(bodyBlock);
  tidy(*definition);
}

} // namespace anysl::rsl
