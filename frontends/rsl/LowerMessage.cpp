//===-- frontends/rsl/LowerMessage.cpp - values for other shaders -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Another shader may be of another library, so that values go to it as AnyslMessage (<anysl/abi.h>)
// describes them: all numbers one after the other in one array, all texts in another.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"
#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

/// Adds a value to those of a message; gives its shape: `f`, `t3`, `s*64`.
std::string Lowering::addItem(Message &message, Type type, unsigned capacity) {
  unsigned elements = capacity ? capacity : 1;
  bool isText = isTextual(type.kind);
  message.items.push_back({type, capacity, message.numberCount, message.textCount});
  message.numberCount += type.isResizable;
  if (isText)
    message.textCount += elements;
  else
    message.numberCount += elements * componentsOf(type.element());
  std::string shape(1, shapeLetter(type.element()));
  if (capacity)
    shape += (type.isResizable ? "*" : "") + std::to_string(capacity);
  return shape;
}

/// The same of a value that has a slot, which says how much room an array has.
std::string Lowering::addItem(Message &message, Type type, Value *value) {
  auto slot = stc::slotInfo(value);
  type.isResizable = lengths.count(value);
  return addItem(message, type, slot ? slot->arrayLength : 0);
}

/// Makes room for all values, when they are known.
void Lowering::makeArrays(Message &message, SMLoc loc) {
  if (std::max(message.numberCount, message.textCount) > stc::maxArrayLength) {
    diags.error(loc, "what is handed to another shader has more than " +
                         Twine(stc::maxArrayLength) + " numbers");
    message = {};
  }
  // An operand is there even if it holds nothing.
  Type number{TypeKind::Float, true}, text{TypeKind::String, true};
  if (message.numberCount)
    number.length = int(message.numberCount);
  if (message.textCount)
    text.length = int(message.textCount);
  message.numbers = temporary(number, "numbers");
  message.texts = temporary(text, "texts");
}

void Lowering::pack(const Message &message, unsigned index, Value *value) {
  if (index >= message.items.size())
    return;
  const Message::Item &item = message.items[index];
  Type type = item.type.element();
  unsigned at = item.number, components = componentsOf(type);
  if (item.type.isResizable)
    copy({TypeKind::Float}, elementOf(message.numbers, at++), lengthOf(value));
  for (unsigned e = 0; e < std::max(item.capacity, 1u); ++e) {
    Value *element = item.capacity ? elementOf(value, e) : value;
    if (isTextual(type.kind)) {
      copy(type, elementOf(message.texts, item.text + e), element);
      continue;
    }
    for (unsigned i = 0; i < components; ++i, ++at) {
      Value *to = elementOf(message.numbers, at);
      if (components == 1)
        copy(type, to, element);
      else if (components == 16)
        b.call(Op::get_matrix, {to, element, number(i / 4), number(i % 4)});
      else
        b.call(opFor(type.kind, Op::get_color, Op::get_color, Op::get_vector),
               {to, element, number(i)});
    }
  }
}

Value *Lowering::unpack(const Message &message, unsigned index) {
  const Message::Item &item = message.items[index];
  Type whole = item.type.withVarying(true), type = whole.element();
  if (item.capacity)
    whole.length = int(item.capacity);
  Value *result = temporary(whole);
  unsigned at = item.number, components = componentsOf(type);
  if (item.type.isResizable)
    copy({TypeKind::Float}, lengths.lookup(result), elementOf(message.numbers, at++));
  for (unsigned e = 0; e < std::max(item.capacity, 1u); ++e) {
    Value *element = item.capacity ? elementOf(result, e) : result;
    if (isTextual(type.kind)) {
      copy(type, element, elementOf(message.texts, item.text + e));
      continue;
    }
    SmallVector<Value *, 17> operands{element};
    for (unsigned i = 0; i < components; ++i)
      operands.push_back(elementOf(message.numbers, at++));
    b.call(components == 1    ? Op::copy_float
           : components == 16 ? Op::make_matrix
                              : opFor(type.kind, Op::copy_float, Op::make_color, Op::make_vector),
           operands);
  }
  return result;
}

void Lowering::appendOperands(const Message &message, SmallVectorImpl<Value *> &operands) {
  operands.append(
      {message.numbers, b.length(message.numberCount), message.texts, b.length(message.textCount)});
}

/// A method as a shader of its own: takes its arguments out of the parameters, calls the method,
/// and puts the arguments and the result back.
void Lowering::lowerMethod(const MethodCall &method) {
  Message message;
  for (const VarDecl *argument : method.arguments) {
    bool isArray = argument->type.isArray();
    addItem(message, argument->type, isArray ? unsigned(argument->type.length) : 0u);
  }
  Type result = method.call->type;
  bool hasResult = shapeLetter(result) != 'v';
  if (hasResult)
    addItem(message, result, 0u);
  for (const VarDecl *part : method.call->results)
    addItem(message, part->type, part->type.isArray() ? unsigned(part->type.length) : 0u);
  message.numbers = method.numbers ? paramSlot(*method.numbers) : nullptr;
  message.texts = method.texts ? paramSlot(*method.texts) : nullptr;
  unsigned index = 0;
  for (const VarDecl *argument : method.arguments)
    slots[argument] = unpack(message, index++);
  Value *value = callFunction(*method.call);
  at(method.call->loc);
  for (unsigned i = 0; i < index; ++i)
    pack(message, i, slots[method.arguments[i]]);
  if (hasResult)
    pack(message, index, value);
  for (const VarDecl *part : method.call->results)
    pack(message, index++, slotOf(*part));
}

} // namespace anysl::rsl
