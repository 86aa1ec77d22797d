//===-- lib/Host/Message.h - values that shaders hand to each other -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// AnyslMessage::what taken apart, and its values as cells, which is how parameters and answers lie.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_HOST_MESSAGE_H
#define ANYSL_LIB_HOST_MESSAGE_H

#include <anysl/anysl.h>
#include <string_view>
#include <vector>

namespace anysl::host {

/// `f`, `t3`, `s*8`: a value's letter and, of an array, its length.
struct ValueShape {
  char letter = 'v';
  bool isArray = false;
  bool isResizable = false; ///< the length at most; the length itself lies before the numbers
  uint32_t length = 1;

  /// The AnyslType; of a triple any. 0: no value.
  uint32_t type() const;
  uint32_t numbers() const;
  uint32_t texts() const { return letter == 's' ? length : 0; }
  bool operator==(const ValueShape &) const = default;
};

/// Where a value of a message lies.
struct ValuePlace {
  ValueShape shape;
  std::string_view name;
  uint32_t number = 0; ///< the first of its numbers
  uint32_t text = 0;   ///< the first of its texts

  /// Moves on behind a value.
  ValuePlace next() const { return {{}, {}, number + shape.numbers(), text + shape.texts()}; }
};

/// Takes a shape off the front of a text; false if there is none.
bool takeShape(std::string_view &text, ValueShape &shape);

/// The values of `name:shape,name:shape`. Those that the message has no room for are left out.
std::vector<ValuePlace> placesOf(const AnyslMessage &message);

/// Whether the message has room for a value there.
bool hasRoom(const AnyslMessage &message, const ValuePlace &place);

/// How many elements an array has; 1 for what is none.
uint32_t elementsOf(const AnyslMessage &message, const ValuePlace &place);
void setElements(AnyslMessage &message, const ValuePlace &place, uint32_t count);

/// The cells of one element, of which there are as many as its type has components.
void readElement(const AnyslMessage &message, const ValuePlace &place, uint32_t element,
                 AnyslCell *cells);
void writeElement(AnyslMessage &message, const ValuePlace &place, uint32_t element,
                  const AnyslCell *cells);

} // namespace anysl::host

#endif
