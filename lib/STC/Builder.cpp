//===-- lib/STC/Builder.cpp - writes subroutine-threaded code -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Builder.h"
#include "lib/STC/MetadataNames.h"
#include "llvm/BinaryFormat/Dwarf.h"
#include "llvm/IR/Constants.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace anysl::stc {
namespace {

/// Whether `operand` may be given to a parameter; asserted, because only a front end's bug can
/// make it untrue here.
[[maybe_unused]] bool fits(const OpParam &param, const Value *operand, const Value *context) {
  switch (param.kind) {
  case ParamKind::In:
  case ParamKind::Out:
  case ParamKind::InOut: {
    auto slot = slotInfo(operand);
    return slot && sameRepresentation(slot->type, param.type) &&
           slot->arrayLength == param.arrayLength;
  }
  case ParamKind::Array: {
    auto slot = slotInfo(operand);
    return slot && slot->type == param.type;
  }
  case ParamKind::Ctx:
    return operand == context;
  case ParamKind::Type:
    return typeOfSymbol(operand).has_value();
  case ParamKind::Slot:
    return slotInfo(operand).has_value();
  case ParamKind::Bool:
    return operand->getType()->isIntegerTy(1);
  case ParamKind::Index:
    return operand->getType()->isIntegerTy(32);
  case ParamKind::Length:
  case ParamKind::Id:
    return isa<ConstantInt>(operand) && operand->getType()->isIntegerTy(32);
  case ParamKind::Number:
    return isa<ConstantFP>(operand) && operand->getType()->isDoubleTy();
  case ParamKind::Text:
    return isa<GlobalVariable>(operand) && !typeOfSymbol(operand);
  }
  return false;
}

} // namespace

Builder::Builder(LLVMContext &context, StringRef sourceFile, StringRef producer, bool debugInfo)
    : mod(std::make_unique<Module>(sourceFile, context)), builder(context), debug(*mod) {
  mod->setSourceFileName(sourceFile);
  mod->addModuleFlag(Module::Warning, "Debug Info Version", DEBUG_METADATA_VERSION);
  debug.createCompileUnit(dwarf::DW_LANG_C, fileNamed(sourceFile), producer, /*isOptimized=*/true,
                          /*Flags=*/"", /*RV=*/0, /*SplitName=*/"",
                          debugInfo ? DICompileUnit::LineTablesOnly : DICompileUnit::NoDebug);
  mod->getOrInsertNamedMetadata(metadata::stc)
      ->addOperand(MDNode::get(context, {ConstantAsMetadata::get(builder.getInt32(stcVersion)),
                                         MDString::get(context, producer)}));
  mod->getOrInsertNamedMetadata(metadata::shaders);
  place.file = sourceFile.str();
}

Builder::~Builder() = default;

DIFile *Builder::fileNamed(StringRef path) {
  DIFile *&file = files[path];
  if (!file)
    file = debug.createFile(path, /*Directory=*/"");
  return file;
}

void Builder::setLocation(StringRef file, unsigned line, unsigned column) {
  if (place.file != file)
    place.file = file.str();
  place.line = line;
  // DILocation keeps sixteen bits of a column.
  place.column = std::min(column, 65535u);
  if (current)
    builder.SetCurrentDebugLocation(location());
}

DILocation *Builder::location() {
  DISubprogram *subprogram = current->getSubprogram();
  DIScope *scope = subprogram;
  if (place.file != subprogram->getFilename())
    scope = debug.createLexicalBlockFile(subprogram, fileNamed(place.file));
  return DILocation::get(mod->getContext(), place.line, place.column, scope);
}

Function *Builder::begin(Function *function) {
  current = function;
  lastAlloc = nullptr;
  DISubprogram *subprogram = debug.createFunction(
      fileNamed(place.file), function->getName(), function->getName(), fileNamed(place.file),
      place.line, debug.createSubroutineType(debug.getOrCreateTypeArray({})), place.line,
      DINode::FlagZero, DISubprogram::SPFlagDefinition | DISubprogram::SPFlagOptimized);
  function->setSubprogram(subprogram);
  builder.SetInsertPoint(BasicBlock::Create(mod->getContext(), "entry", function));
  builder.SetCurrentDebugLocation(location());
  return function;
}

Function *Builder::beginFunction(StringRef name) {
  OpParam ctx{ParamKind::Ctx};
  auto *type = functionType(mod->getContext(), ResultKind::None, ctx);
  auto *created = Function::Create(type, GlobalValue::ExternalLinkage, name, *mod);
  created->getArg(0)->setName("ctx");
  return begin(created);
}

Function *Builder::beginOperator(Op op) {
  assert(info(op).purity != Purity::Structural && "structural operators have no definition");
  Function *defined = declaration(op);
  assert(defined->isDeclaration() && "an operator is defined once");
  for (unsigned i = 0; i < defined->arg_size(); ++i)
    if (info(op).params[i].kind == ParamKind::Ctx)
      defined->getArg(i)->setName("ctx");
  return begin(defined);
}

Function *Builder::beginFunction(StringRef name, ResultKind result, ArrayRef<OpParam> params) {
  assert(result != ResultKind::Slot && "a function gives no slot");
  LLVMContext &context = mod->getContext();
  auto *created = Function::Create(functionType(context, result, params),
                                   GlobalValue::InternalLinkage, name, *mod);
  SmallVector<Metadata *> signature;
  for (const OpParam &param : params)
    signature.push_back(MDString::get(context, toString(param)));
  created->setMetadata(metadata::signature, MDNode::get(context, signature));
  return begin(created);
}

Value *Builder::context() const {
  auto signature = signatureOf(*current);
  for (unsigned i = 0; i < signature->size(); ++i)
    if ((*signature)[i].kind == ParamKind::Ctx)
      return current->getArg(i);
  return nullptr;
}

BasicBlock *Builder::block(StringRef name) {
  return BasicBlock::Create(mod->getContext(), name, current);
}

Function *Builder::declaration(Op op) {
  const OpInfo &operation = info(op);
  std::string symbol = operation.symbol();
  if (Function *known = mod->getFunction(symbol))
    return known;
  return Function::Create(functionType(mod->getContext(), operation), GlobalValue::ExternalLinkage,
                          symbol, *mod);
}

CallInst *Builder::makeCall(Function *callee, ArrayRef<Value *> operands) {
  assert(place.line && "a location must be set before anything is called");
  return builder.CreateCall(callee, operands);
}

CallInst *Builder::makeAlloc(Op op, ArrayRef<Value *> operands, StringRef name, Storage storage) {
  // Allocations stand together at the start of the entry block, in the order in which they come.
  IRBuilderBase::InsertPointGuard guard(builder);
  BasicBlock &entry = current->getEntryBlock();
  builder.SetInsertPoint(&entry, lastAlloc ? std::next(lastAlloc->getIterator()) : entry.begin());
  builder.SetCurrentDebugLocation(location());
  lastAlloc = makeCall(declaration(op), operands);
  lastAlloc->setName(name);
  LLVMContext &context = mod->getContext();
  if (!name.empty())
    lastAlloc->setMetadata(metadata::name, MDNode::get(context, MDString::get(context, name)));
  if (storage == Storage::Uniform)
    lastAlloc->setMetadata(metadata::storage,
                           MDNode::get(context, MDString::get(context, nameOf(storage))));
  return lastAlloc;
}

Value *Builder::alloc(Type type, StringRef name, Storage storage) {
  return makeAlloc(Op::alloc, {typeSymbol(type)}, name, storage);
}

Value *Builder::allocArray(Type type, unsigned count, StringRef name, Storage storage) {
  assert(count > 0 && count <= maxArrayLength && "an array has a sensible length");
  return makeAlloc(Op::alloc_array, {typeSymbol(type), length(count)}, name, storage);
}

Value *Builder::element(Value *array, Value *index) {
  auto slot = slotInfo(array);
  assert(slot && slot->arrayLength && "only arrays have elements");
  return makeCall(declaration(Op::element),
                  {array, typeSymbol(slot->type), length(slot->arrayLength), index});
}

Value *Builder::call(Op op, ArrayRef<Value *> operands) {
  [[maybe_unused]] const OpInfo &operation = info(op);
  assert(operation.purity != Purity::Structural && "use alloc, allocArray, element");
  assert(operands.size() == operation.params.size() && "wrong number of operands");
  for (unsigned i = 0; i < operands.size(); ++i)
    assert(fits(operation.params[i], operands[i], context()) && "wrong type of operand");
  return makeCall(declaration(op), operands);
}

Value *Builder::callFunction(Function *callee, ArrayRef<Value *> operands) {
  [[maybe_unused]] auto signature = signatureOf(*callee);
  assert(signature && operands.size() == signature->size() && "wrong number of operands");
  for (unsigned i = 0; i < operands.size(); ++i)
    assert(fits((*signature)[i], operands[i], context()) && "wrong type of operand");
  return makeCall(callee, operands);
}

Constant *Builder::number(double value) {
  return ConstantFP::get(llvm::Type::getDoubleTy(mod->getContext()), value);
}

Constant *Builder::text(StringRef value) {
  assert(!value.contains('\0') && "constant text ends at its first NUL");
  Constant *&known = texts[value];
  if (!known) {
    auto *data = ConstantDataArray::getString(mod->getContext(), value);
    auto *global = new GlobalVariable(*mod, data->getType(), /*isConstant=*/true,
                                      GlobalValue::PrivateLinkage, data, "text");
    global->setUnnamedAddr(GlobalValue::UnnamedAddr::Global);
    known = global;
  }
  return known;
}

Constant *Builder::typeSymbol(Type type) {
  std::string name = (Twine(typeSymbolPrefix) + info(type).name).str();
  if (GlobalVariable *known = mod->getNamedGlobal(name))
    return known;
  return new GlobalVariable(*mod, llvm::Type::getInt8Ty(mod->getContext()), /*isConstant=*/false,
                            GlobalValue::ExternalLinkage, nullptr, name);
}

void Builder::addShader(const ShaderInfo &shader) {
  assert(shader.body && shader.init && "a shader has a body and an init");
  LLVMContext &context = mod->getContext();
  auto text = [&](StringRef value) -> Metadata * { return MDString::get(context, value); };
  auto flag = [&](bool value) -> Metadata * {
    return ConstantAsMetadata::get(builder.getInt1(value));
  };
  auto integer = [&](unsigned value) -> Metadata * {
    return ConstantAsMetadata::get(builder.getInt32(value));
  };

  SmallVector<Metadata *> params, globals;
  for (const ParamInfo &param : shader.params)
    params.push_back(MDNode::get(context, {text(param.name), text(info(param.type).name),
                                           text(nameOf(param.storage)), flag(param.output),
                                           integer(param.arrayLength), integer(param.firstCell)}));
  for (const GlobalInfo &global : shader.globals)
    globals.push_back(
        MDNode::get(context, {integer(global.id), flag(global.read), flag(global.written)}));
  mod->getOrInsertNamedMetadata(metadata::shaders)
      ->addOperand(MDNode::get(
          context, {text(shader.name), text(nameOf(shader.kind)), ValueAsMetadata::get(shader.body),
                    ValueAsMetadata::get(shader.init), MDNode::get(context, params),
                    MDNode::get(context, globals)}));
}

std::unique_ptr<Module> Builder::finish() {
  debug.finalize();
  current = nullptr;
  return std::move(mod);
}

} // namespace anysl::stc
