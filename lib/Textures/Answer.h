//===-- lib/Textures/Answer.h - textureinfo() -------------------------------------*- C++
//-*-------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_TEXTURES_ANSWER_H
#define ANYSL_LIB_TEXTURES_ANSWER_H

#include "lib/Textures/Textures.h"

#include <anysl/anysl.h>

namespace anysl::textures {

/// Answers textureinfo(), for the service `query` of a renderer: several numbers go into any
/// variable with as many components.
inline int answer(Textures &textures, void *renderer, const AnyslShadeArgs *args,
                  const AnyslQuery &query, AnyslCell *value) {
  std::optional<TextureFact> fact = textures.fact(query.subject, query.name);
  if (!fact)
    return 0;
  AnyslCell cell;
  if (fact->text) {
    // With nothing appended, it is the text where libanysl keeps it.
    cell.string = args->services->append(renderer, fact->text->c_str(), "", 0, 0, nullptr);
    return anysl_answer(&query, ANYSL_STRING, 0, &cell, value);
  }
  const std::vector<double> &numbers = fact->numbers;
  if (numbers.size() == 1 && !query.array_length) {
    cell.number = numbers[0];
    return anysl_answer(&query, ANYSL_FLOAT, 0, &cell, value);
  }
  size_t components = anysl_type_components(query.type);
  size_t elements = query.array_length == ANYSL_ANY_LENGTH ? numbers.size() / components
                    : query.array_length                   ? query.array_length
                                                           : 1;
  if (query.type == ANYSL_STRING || numbers.size() != components * elements ||
      query.element >= elements)
    return 0;
  for (size_t c = 0; c < components; ++c)
    value[c].number = numbers[query.element * components + c];
  return 1;
}

} // namespace anysl::textures

#endif
