//===-- anysl/standard/message.h - values that shaders hand to each other ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// An operator gets the numbers and texts of an AnyslMessage as two arrays of the shader's own. They
// become what the renderer takes inside of a function that stays a call: widened code makes it for
// one lane after the other, each with its own arrays. Numbers that come back carry no derivatives.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_MESSAGE_H
#define ANYSL_STANDARD_MESSAGE_H

#include <anysl/standard/context.h>

namespace anysl {

/// Calls `ask(AnyslMessage &)`. Only for functions that are not inlined: it makes arrays of a
/// length that is not known when compiling.
template <typename Ask>
inline auto withMessage(const char *what, const anysl_float *numbers, uint32_t numberCount,
                        const anysl_string *texts, uint32_t textCount, Ask &&ask) {
  auto *values = static_cast<double *>(__builtin_alloca((numberCount + 1) * sizeof(double)));
  auto **words = static_cast<const char **>(__builtin_alloca((textCount + 1) * sizeof(char *)));
  for (uint32_t i = 0; i < numberCount; ++i)
    values[i] = double(numberOf(numbers[i]));
  for (uint32_t i = 0; i < textCount; ++i)
    words[i] = texts[i] ? texts[i] : "";
  AnyslMessage message = {sizeof(AnyslMessage), numberCount, textCount, 0,
                          what ? what : "",     values,      words};
  return ask(message);
}

/// Puts what a renderer has changed back into the shader's arrays.
inline void takeBack(const AnyslMessage &message, anysl_float *numbers, anysl_string *texts) {
  for (uint32_t i = 0; i < message.number_count; ++i)
    numbers[i] = anysl_float(message.numbers[i]);
  for (uint32_t i = 0; i < message.text_count; ++i)
    texts[i] = message.texts[i];
}

} // namespace anysl

#endif // ANYSL_STANDARD_MESSAGE_H
