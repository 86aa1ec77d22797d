//===-- lib/Host/Message.cpp - values that shaders hand to each other -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Message.h"
#include "lib/Host/Internal.h"
#include <algorithm>
#include <cctype>

using namespace anysl::host;

namespace anysl::host {

uint32_t ValueShape::type() const {
  switch (letter) {
  case 'f':
    return ANYSL_FLOAT;
  case 't':
    return ANYSL_VECTOR;
  case 'm':
    return ANYSL_MATRIX;
  case 's':
    return ANYSL_STRING;
  default:
    return 0;
  }
}

uint32_t ValueShape::numbers() const {
  uint32_t each = letter == 's' || !type() ? 0 : anysl_type_components(type());
  return isResizable + each * length;
}

bool takeShape(std::string_view &text, ValueShape &shape) {
  shape = {};
  if (text.empty())
    return false;
  shape.letter = text[0];
  text.remove_prefix(1);
  if (!text.empty() && text[0] == '*') {
    shape.isResizable = true;
    text.remove_prefix(1);
  }
  uint32_t length = 0;
  while (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) && length < 1u << 20) {
    length = length * 10 + uint32_t(text[0] - '0');
    shape.isArray = true;
    text.remove_prefix(1);
  }
  shape.length = shape.isArray ? length : 1;
  return shape.type() || (shape.letter == 'v' && !shape.isArray);
}

bool hasRoom(const AnyslMessage &message, const ValuePlace &place) {
  ValuePlace end = place.next();
  return end.number <= message.number_count && end.text <= message.text_count;
}

std::vector<ValuePlace> placesOf(const AnyslMessage &message) {
  std::vector<ValuePlace> places;
  std::string_view rest = message.what;
  ValuePlace place;
  while (!rest.empty()) {
    size_t comma = std::min(rest.find(','), rest.size());
    std::string_view item = rest.substr(0, comma);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    size_t colon = item.rfind(':');
    if (colon == item.npos)
      break;
    place.name = item.substr(0, colon);
    item.remove_prefix(colon + 1);
    if (!takeShape(item, place.shape) || !item.empty() || !hasRoom(message, place))
      break;
    places.push_back(place);
    place = place.next();
  }
  return places;
}

uint32_t elementsOf(const AnyslMessage &message, const ValuePlace &place) {
  if (!place.shape.isResizable)
    return place.shape.length;
  double length = message.numbers[place.number];
  return length > 0 ? uint32_t(std::min(length, double(place.shape.length))) : 0;
}

void setElements(AnyslMessage &message, const ValuePlace &place, uint32_t count) {
  if (place.shape.isResizable)
    message.numbers[place.number] = count;
}

void readElement(const AnyslMessage &message, const ValuePlace &place, uint32_t element,
                 AnyslCell *cells) {
  if (place.shape.letter == 's') {
    cells->string = message.texts[place.text + element];
    return;
  }
  uint32_t count = anysl_type_components(place.shape.type());
  const double *from =
      message.numbers + place.number + place.shape.isResizable + size_t(element) * count;
  for (uint32_t i = 0; i < count; ++i)
    cells[i].number = from[i];
}

void writeElement(AnyslMessage &message, const ValuePlace &place, uint32_t element,
                  const AnyslCell *cells) {
  if (place.shape.letter == 's') {
    message.texts[place.text + element] = cells->string ? cells->string : "";
    return;
  }
  uint32_t count = anysl_type_components(place.shape.type());
  double *to = message.numbers + place.number + place.shape.isResizable + size_t(element) * count;
  for (uint32_t i = 0; i < count; ++i)
    to[i] = cells[i].number;
}

} // namespace anysl::host

extern "C" void anysl_message_answer(AnyslMessage *message,
                                     int (*ask)(void *data, const AnyslQuery *query,
                                                AnyslCell *value),
                                     void *data) {
  guarded([&] {
    for (const ValuePlace &place : placesOf(*message)) {
      std::string_view name = place.name;
      std::string_view group = name.substr(0, std::min(name.find(':'), name.size()));
      AnyslQuery query = {};
      query.kind = group == "surface"        ? ANYSL_QUERY_surface
                   : group == "displacement" ? ANYSL_QUERY_displacement
                   : group == "attribute"    ? ANYSL_QUERY_attribute
                                             : ANYSL_QUERY_PRIMITIVE;
      std::string about(name.substr(std::min(group.size() + 1, name.size())));
      query.type = place.shape.type();
      query.array_length = !place.shape.isArray      ? 0
                           : place.shape.isResizable ? ANYSL_ANY_LENGTH
                                                     : place.shape.length;
      query.name = about.c_str();
      query.subject = "";
      uint32_t known = 0;
      for (AnyslCell value[16]; known < place.shape.length; ++known) {
        query.element = known;
        if (!ask(data, &query, value))
          break;
        writeElement(*message, place, known, value);
      }
      if (known)
        setElements(*message, place, known);
    }
    return ANYSL_OK;
  });
}
