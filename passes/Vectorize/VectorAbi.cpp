//===-- passes/Vectorize/VectorAbi.cpp - names and signatures of vector variants --------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/VectorAbi.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/VFABIDemangler.h"

using namespace llvm;

namespace anysl {

//===-- Names ---------------------------------------------------------------===//

static bool consumeParam(StringRef &text, VariantParam &param) {
  using Kind = VariantParam::Kind;
  int64_t sign = 1;
  if (text.consume_front("v")) {
    param.kind = Kind::Vector;
  } else if (text.consume_front("u")) {
    param.kind = Kind::Uniform;
  } else if (text.consume_front("ls") || text.consume_front("Rs")) {
    param.kind = Kind::LinearByParam;
    if (text.consumeInteger(10, param.step))
      return false;
  } else if (text.consume_front("l") || text.consume_front("R")) {
    param.kind = Kind::Linear;
    param.step = 1;
    if (text.consume_front("n"))
      sign = -1;
    if (!text.empty() && isDigit(text.front()) && text.consumeInteger(10, param.step))
      return false;
    param.step *= sign;
    // Step 0 is how GCC spells a linear parameter that does not move.
    if (param.step == 0)
      param.kind = Kind::Uniform;
  } else if (text.consume_front("Ls") || text.consume_front("L")) {
    // A reference whose referred values are linear travels as one address per lane.
    param.kind = Kind::Vector;
    text.consume_front("n");
    int64_t ignored;
    if (!text.empty() && isDigit(text.front()) && text.consumeInteger(10, ignored))
      return false;
  } else {
    return false;
  }
  if (text.consume_front("a")) {
    uint64_t align;
    if (text.consumeInteger(10, align) || !isPowerOf2_64(align))
      return false;
    param.align = Align(align);
  }
  return true;
}

std::optional<VariantName> parseVariantName(StringRef text) {
  VariantName name;
  name.functionName = text.str();
  if (size_t open = text.find('('); open != StringRef::npos && text.ends_with(")")) {
    name.functionName = text.slice(open + 1, text.size() - 1).str();
    text = text.take_front(open);
  }
  if (!text.consume_front("_ZGV"))
    return std::nullopt;
  if (text.consume_front("_LLVM_"))
    name.isa = Isa::Llvm;
  else if (text.consume_front("b"))
    name.isa = Isa::Sse;
  else if (text.consume_front("c"))
    name.isa = Isa::Avx;
  else if (text.consume_front("d"))
    name.isa = Isa::Avx2;
  else if (text.consume_front("e"))
    name.isa = Isa::Avx512;
  else
    return std::nullopt;
  name.masked = text.starts_with("M");
  if (!text.consume_front("M") && !text.consume_front("N"))
    return std::nullopt;
  if (text.consumeInteger(10, name.width) || name.width < 2 || name.width > 64 ||
      !isPowerOf2_32(name.width))
    return std::nullopt;
  while (!text.starts_with("_")) {
    VariantParam param;
    if (!consumeParam(text, param))
      return std::nullopt;
    name.params.push_back(param);
  }
  name.scalarName = text.drop_front().str();
  if (name.scalarName.empty() || name.functionName.empty())
    return std::nullopt;
  return name;
}

SmallVector<VariantName, 4> variantNames(AttributeList attributes) {
  SmallVector<VariantName, 4> names;
  for (Attribute attribute : attributes.getFnAttrs()) {
    if (!attribute.isStringAttribute())
      continue;
    StringRef kind = attribute.getKindAsString();
    if (kind == VFABI::MappingsAttrName) {
      SmallVector<StringRef, 8> list;
      attribute.getValueAsString().split(list, ',', -1, false);
      for (StringRef item : list)
        if (auto name = parseVariantName(item.trim()))
          names.push_back(std::move(*name));
    } else if (kind.starts_with("_ZGV")) {
      if (auto name = parseVariantName(kind))
        names.push_back(std::move(*name));
    }
  }
  return names;
}

//===-- Instruction sets ----------------------------------------------------===//

StringRef featuresOf(Isa isa) {
  switch (isa) {
  case Isa::Sse:
    return "+sse4.2,+popcnt";
  case Isa::Avx:
    return "+avx,+popcnt";
  case Isa::Avx2:
    return "+avx2,+fma,+f16c,+bmi,+bmi2,+lzcnt,+movbe,+popcnt";
  case Isa::Avx512:
    return "+avx512f,+avx512vl,+avx512bw,+avx512dq,+avx512cd,+avx2,+fma,+f16c,+bmi,+bmi2,+lzcnt,"
           "+movbe,+popcnt";
  case Isa::Llvm:
    return "";
  }
  llvm_unreachable("unknown instruction set");
}

unsigned registerBits(Isa isa, bool forFloats) {
  switch (isa) {
  case Isa::Sse:
    return 128;
  case Isa::Avx:
    return forFloats ? 256 : 128;
  case Isa::Avx2:
    return 256;
  case Isa::Avx512:
    return 512;
  case Isa::Llvm:
    return 0;
  }
  llvm_unreachable("unknown instruction set");
}

//===-- Signatures ----------------------------------------------------------===//

Type *widenedType(Type *type, unsigned width) {
  if (type->isVoidTy())
    return type;
  if (auto *structure = dyn_cast<StructType>(type)) {
    SmallVector<Type *, 8> elements;
    for (Type *element : structure->elements())
      elements.push_back(widenedType(element, width));
    return StructType::get(type->getContext(), elements);
  }
  if (auto *array = dyn_cast<ArrayType>(type))
    return ArrayType::get(widenedType(array->getElementType(), width), array->getNumElements());
  if (auto *vector = dyn_cast<FixedVectorType>(type))
    return ArrayType::get(FixedVectorType::get(vector->getElementType(), width),
                          vector->getNumElements());
  return FixedVectorType::get(type, width);
}

VariantSignature::Slot VariantSignature::vectorSlot(Isa isa, Type *type) const {
  Slot slot;
  slot.type = widenedType(type, width);
  slot.lanesPerPiece = width;
  if (isa == Isa::Llvm)
    return slot;
  slot.form = Form::Pieces;
  slot.element = type->isIntegerTy(1) ? Type::getInt8Ty(type->getContext()) : type;
  unsigned bits = type->isPointerTy() ? 64 : slot.element->getPrimitiveSizeInBits();
  unsigned perRegister = registerBits(isa, type->isFloatingPointTy()) / bits;
  slot.lanesPerPiece = std::max(1u, std::min(width, perRegister));
  slot.pieces = width / slot.lanesPerPiece;
  return slot;
}

/// The type that decides a mask's form and, for a compiler, the number of lanes: the result's, else
/// the first parameter's that has one value per lane, else int.
static Type *characteristicType(const VariantName &name, FunctionType *scalar) {
  Type *type = scalar->getReturnType();
  if (type->isVoidTy()) {
    type = nullptr;
    for (unsigned i = 0; i < name.params.size() && !type; ++i)
      if (name.params[i].kind == VariantParam::Kind::Vector)
        type = scalar->getParamType(i);
  }
  if (!type || !(type->isIntegerTy() || type->isPointerTy() || type->isFloatingPointTy()))
    return Type::getInt32Ty(scalar->getContext());
  return type->isIntegerTy(1) ? Type::getInt8Ty(type->getContext()) : type;
}

static bool isAbiScalar(Type *type) {
  if (type->isPointerTy())
    return true;
  unsigned bits = type->getPrimitiveSizeInBits();
  if (type->isIntegerTy())
    return bits == 1 || bits == 8 || bits == 16 || bits == 32 || bits == 64;
  return type->isFloatTy() || type->isDoubleTy();
}

std::optional<VariantSignature> VariantSignature::get(const VariantName &name, FunctionType *scalar,
                                                      const DataLayout &layout, std::string &why) {
  if (scalar->isVarArg() || name.params.size() != scalar->getNumParams()) {
    why = "its parameters do not match the variant's name";
    return std::nullopt;
  }
  VariantSignature signature;
  signature.width = name.width;
  signature.masked = name.masked;
  signature.scalarType = scalar;
  LLVMContext &context = scalar->getContext();

  SmallVector<Type *, 16> types;
  Type *returned = scalar->getReturnType();
  if (!returned->isVoidTy()) {
    if (name.isa != Isa::Llvm && !isAbiScalar(returned)) {
      why = "the vector ABI has no form for its result";
      return std::nullopt;
    }
    signature.result = signature.vectorSlot(name.isa, returned);
    if (signature.result.pieces > 1) {
      signature.returnsByReference = true;
      types.push_back(PointerType::getUnqual(context));
      returned = Type::getVoidTy(context);
    } else {
      returned = signature.result.form == Form::Direct
                     ? signature.result.type
                     : FixedVectorType::get(signature.result.element, name.width);
    }
  }
  for (auto [param, type] : zip(name.params, scalar->params())) {
    bool isAddress = type->isPointerTy(), isInteger = type->isIntegerTy();
    if (param.kind == VariantParam::Kind::Linear && !isAddress && !isInteger) {
      why = "a parameter that is neither integer nor pointer cannot be linear";
      return std::nullopt;
    }
    if (param.kind == VariantParam::Kind::LinearByParam &&
        (!isInteger || param.step < 0 || param.step >= scalar->getNumParams() ||
         !scalar->getParamType(param.step)->isIntegerTy())) {
      why = "only an integer parameter can be linear by another one";
      return std::nullopt;
    }
    Slot slot;
    slot.type = type;
    if (param.kind == VariantParam::Kind::Vector) {
      if (name.isa != Isa::Llvm && !isAbiScalar(type)) {
        why = "the vector ABI has no form for one of its parameters";
        return std::nullopt;
      }
      slot = signature.vectorSlot(name.isa, type);
    }
    Type *passed = slot.form == Form::Direct
                       ? slot.type
                       : FixedVectorType::get(slot.element, slot.lanesPerPiece);
    types.append(slot.pieces, passed);
    signature.slots.push_back(slot);
  }
  if (name.masked) {
    Slot slot;
    slot.type = FixedVectorType::get(Type::getInt1Ty(context), name.width);
    Type *passed = slot.type;
    if (name.isa == Isa::Avx512) {
      // One bit per lane; a function over bytes takes 64 at once, any other 32.
      unsigned bits = characteristicType(name, scalar)->isIntegerTy(8) ? 64 : 32;
      slot.form = Form::IntegerMask;
      slot.lanesPerPiece = std::min(bits, name.width);
      slot.pieces = name.width / slot.lanesPerPiece;
      passed = slot.element = IntegerType::get(context, bits);
    } else if (name.isa != Isa::Llvm) {
      slot = signature.vectorSlot(name.isa, characteristicType(name, scalar));
      passed = FixedVectorType::get(slot.element, slot.lanesPerPiece);
    }
    types.append(slot.pieces, passed);
    signature.slots.push_back(slot);
  }
  signature.functionType = FunctionType::get(returned, types, false);
  return signature;
}

std::optional<VariantSignature> VariantSignature::getFor(const VariantName &name,
                                                         FunctionType *scalar,
                                                         const Function &variant,
                                                         std::string &why) {
  auto signature = get(name, scalar, variant.getParent()->getDataLayout(), why);
  FunctionType *given = variant.getFunctionType();
  if (!signature || signature->functionType == given)
    return signature;

  // Match the given parameters one scalar parameter at a time.
  why = "the type of " + variant.getName().str() + " does not fit the variant's name";
  unsigned next = 0, count = given->getNumParams();
  if (!scalar->getReturnType()->isVoidTy()) {
    Slot &result = signature->result;
    signature->returnsByReference = false;
    if (given->getReturnType()->isVoidTy()) {
      if (next == count || !variant.hasParamAttribute(next, Attribute::StructRet))
        return std::nullopt;
      ++next;
      signature->returnsByReference = true;
      result.form = Form::ByReference;
    } else if (given->getReturnType() == result.type) {
      result.form = Form::Direct;
    } else if (auto *vector = dyn_cast<FixedVectorType>(given->getReturnType());
               vector && result.element && vector->getElementType() == result.element &&
               vector->getNumElements() == name.width) {
      result.form = Form::Pieces;
      result.pieces = 1;
      result.lanesPerPiece = name.width;
    } else {
      return std::nullopt;
    }
  }
  for (auto [i, slot] : enumerate(signature->slots)) {
    bool isMask = i == scalar->getNumParams();
    bool isVector = isMask || name.params[i].kind == VariantParam::Kind::Vector;
    if (next == count)
      return std::nullopt;
    Type *type = given->getParamType(next);
    if (!isVector) {
      if (type != scalar->getParamType(i))
        return std::nullopt;
      ++next;
      continue;
    }
    Type *element = isMask ? nullptr : scalar->getParamType(i);
    if (isMask && isa<IntegerType>(type)) {
      slot.form = Form::IntegerMask;
      slot.element = type;
      slot.lanesPerPiece = std::min(type->getIntegerBitWidth(), name.width);
      slot.pieces = name.width / slot.lanesPerPiece;
    } else if (auto *vector = dyn_cast<FixedVectorType>(type)) {
      bool fits = isMask
                      ? vector->getElementType()->isIntegerTy() ||
                            vector->getElementType()->isFloatingPointTy()
                      : vector->getElementType() == element ||
                            (element->isIntegerTy(1) && vector->getElementType()->isIntegerTy(8));
      if (!fits || name.width % vector->getNumElements())
        return std::nullopt;
      slot.element = vector->getElementType();
      slot.lanesPerPiece = vector->getNumElements();
      slot.pieces = name.width / slot.lanesPerPiece;
      slot.form = Form::Pieces;
      if (isMask)
        slot.type = FixedVectorType::get(slot.element, name.width);
    } else if (type->isPointerTy() && variant.hasParamAttribute(next, Attribute::ByVal)) {
      slot.form = Form::ByReference;
      slot.pieces = 1;
      slot.type = variant.getParamByValType(next);
      if (slot.type != signature->slots[i].type && !isMask)
        return std::nullopt;
    } else if (type == slot.type) {
      slot.form = Form::Direct;
      slot.pieces = 1;
    } else {
      return std::nullopt;
    }
    for (unsigned piece = 0; piece < slot.pieces; ++piece, ++next)
      if (next == count || given->getParamType(next) != type)
        return std::nullopt;
  }
  if (next != count)
    return std::nullopt;
  signature->functionType = given;
  return signature;
}

void VariantSignature::addAttributes(Function &function) const {
  if (!returnsByReference)
    return;
  Type *inMemory = result.type;
  if (result.element && !inMemory->isAggregateType())
    inMemory = FixedVectorType::get(result.element, width);
  function.addParamAttr(0, Attribute::getWithStructRetType(function.getContext(), inMemory));
}

//===-- Packing -------------------------------------------------------------===//

static SmallVector<int, 64> laneRange(unsigned from, unsigned count) {
  SmallVector<int, 64> lanes(count);
  for (unsigned i = 0; i < count; ++i)
    lanes[i] = from + i;
  return lanes;
}

/// Joins equal vectors end to end.
static Value *concatenate(IRBuilder<> &builder, ArrayRef<Value *> pieces) {
  SmallVector<Value *, 8> parts(pieces);
  while (parts.size() > 1) {
    unsigned lanes = cast<FixedVectorType>(parts[0]->getType())->getNumElements();
    SmallVector<Value *, 8> joined;
    for (unsigned i = 0; i < parts.size(); i += 2)
      joined.push_back(
          builder.CreateShuffleVector(parts[i], parts[i + 1], laneRange(0, 2 * lanes)));
    parts = std::move(joined);
  }
  return parts[0];
}

/// A mask in the form of a vector has all bits of a lane set or none, so the sign tells.
static Value *signBits(IRBuilder<> &builder, Value *mask) {
  auto *type = cast<FixedVectorType>(mask->getType());
  if (type->getElementType()->isIntegerTy(1))
    return mask;
  Type *integers =
      FixedVectorType::get(builder.getIntNTy(type->getScalarSizeInBits()), type->getNumElements());
  Value *bits = builder.CreateBitCast(mask, integers);
  return builder.CreateICmpSLT(bits, Constant::getNullValue(integers));
}

Value *VariantSignature::unpack(IRBuilder<> &builder, const Slot &slot, ArrayRef<Value *> pieces,
                                bool isMask) const {
  switch (slot.form) {
  case Form::Direct:
    return pieces[0];
  case Form::ByReference: {
    Value *whole = builder.CreateLoad(slot.type, pieces[0]);
    return isMask ? signBits(builder, whole) : whole;
  }
  case Form::IntegerMask: {
    SmallVector<Value *, 4> masks;
    for (Value *piece : pieces) {
      Value *bits = builder.CreateTrunc(piece, builder.getIntNTy(slot.lanesPerPiece));
      masks.push_back(builder.CreateBitCast(
          bits, FixedVectorType::get(builder.getInt1Ty(), slot.lanesPerPiece)));
    }
    return concatenate(builder, masks);
  }
  case Form::Pieces: {
    Value *whole = concatenate(builder, pieces);
    if (isMask)
      return signBits(builder, whole);
    if (slot.type->getScalarType()->isIntegerTy(1) && !slot.element->isIntegerTy(1))
      whole = builder.CreateTrunc(whole, slot.type);
    return whole;
  }
  }
  llvm_unreachable("unknown form");
}

void VariantSignature::pack(IRBuilder<> &builder, const Slot &slot, Value *value, bool isMask,
                            SmallVectorImpl<Value *> &pieces) const {
  Value *whole = value;
  if (isMask && (slot.form == Form::Pieces || slot.form == Form::ByReference)) {
    Type *scalar = slot.form == Form::Pieces ? slot.element : slot.type->getScalarType();
    if (!scalar->isIntegerTy(1)) {
      unsigned bits = scalar->isPointerTy() ? 64 : scalar->getPrimitiveSizeInBits();
      whole = builder.CreateSExt(value, FixedVectorType::get(builder.getIntNTy(bits), width));
      Type *type = FixedVectorType::get(scalar, width);
      whole = scalar->isPointerTy() ? builder.CreateIntToPtr(whole, type)
                                    : builder.CreateBitCast(whole, type);
    }
  } else if (slot.form == Form::Pieces && slot.type->getScalarType()->isIntegerTy(1) &&
             !slot.element->isIntegerTy(1)) {
    whole = builder.CreateZExt(value, FixedVectorType::get(slot.element, width));
  }
  switch (slot.form) {
  case Form::Direct:
    pieces.push_back(whole);
    return;
  case Form::ByReference: {
    Function *function = builder.GetInsertBlock()->getParent();
    IRBuilder<> entry(&function->getEntryBlock(), function->getEntryBlock().begin());
    Value *slotAddress = entry.CreateAlloca(slot.type);
    builder.CreateStore(whole, slotAddress);
    pieces.push_back(slotAddress);
    return;
  }
  case Form::IntegerMask:
    for (unsigned i = 0; i < slot.pieces; ++i) {
      Value *lanes = value;
      if (slot.pieces > 1)
        lanes = builder.CreateShuffleVector(value,
                                            laneRange(i * slot.lanesPerPiece, slot.lanesPerPiece));
      Value *bits = builder.CreateBitCast(lanes, builder.getIntNTy(slot.lanesPerPiece));
      pieces.push_back(builder.CreateZExt(bits, slot.element));
    }
    return;
  case Form::Pieces:
    for (unsigned i = 0; i < slot.pieces; ++i)
      pieces.push_back(slot.pieces == 1
                           ? whole
                           : builder.CreateShuffleVector(
                                 whole, laneRange(i * slot.lanesPerPiece, slot.lanesPerPiece)));
    return;
  }
}

SmallVector<Value *, 8> VariantSignature::unpackArguments(IRBuilder<> &builder,
                                                          Function &variant) const {
  SmallVector<Value *, 8> values;
  unsigned next = returnsByReference;
  for (auto [i, slot] : enumerate(slots)) {
    SmallVector<Value *, 4> pieces;
    for (unsigned piece = 0; piece < slot.pieces; ++piece)
      pieces.push_back(variant.getArg(next++));
    values.push_back(unpack(builder, slot, pieces, i == scalarType->getNumParams()));
  }
  return values;
}

void VariantSignature::packReturn(IRBuilder<> &builder, Function &variant, Value *value) const {
  if (!value || scalarType->getReturnType()->isVoidTy()) {
    builder.CreateRetVoid();
    return;
  }
  if (returnsByReference) {
    Value *whole = value;
    if (result.type->getScalarType()->isIntegerTy(1) && result.element)
      whole = builder.CreateZExt(value, FixedVectorType::get(result.element, width));
    // Pieces lie one after the other, aligned as one piece is.
    Align align(registerBits(Isa::Sse, true) / 8);
    builder.CreateAlignedStore(whole, variant.getArg(0), align);
    builder.CreateRetVoid();
    return;
  }
  SmallVector<Value *, 1> pieces;
  pack(builder, result, value, false, pieces);
  builder.CreateRet(pieces[0]);
}

CallInst *VariantSignature::call(IRBuilder<> &builder, FunctionCallee variant,
                                 ArrayRef<Value *> arguments, Value *&value) const {
  SmallVector<Value *, 16> passed;
  Value *returned = nullptr;
  Type *memoryType = result.type;
  if (returnsByReference) {
    if (result.element && result.type->getScalarType()->isIntegerTy(1))
      memoryType = FixedVectorType::get(result.element, width);
    Function *function = builder.GetInsertBlock()->getParent();
    IRBuilder<> entry(&function->getEntryBlock(), function->getEntryBlock().begin());
    returned = entry.CreateAlloca(memoryType);
    passed.push_back(returned);
  }
  for (auto [i, slot] : enumerate(slots))
    pack(builder, slot, arguments[i], i == scalarType->getNumParams(), passed);
  CallInst *call = builder.CreateCall(variant, passed);
  if (auto *function = dyn_cast<Function>(variant.getCallee())) {
    call->setCallingConv(function->getCallingConv());
    for (unsigned i = 0; i < function->arg_size(); ++i)
      for (auto kind : {Attribute::StructRet, Attribute::ByVal})
        if (Attribute attribute = function->getParamAttribute(i, kind); attribute.isValid())
          call->addParamAttr(i, attribute);
  }
  value = nullptr;
  if (returnsByReference) {
    value = builder.CreateLoad(memoryType, returned);
    if (memoryType != result.type)
      value = builder.CreateTrunc(value, result.type);
  } else if (!scalarType->getReturnType()->isVoidTy()) {
    value = unpack(builder, result, {call}, false);
  }
  return call;
}

} // namespace anysl
