//===-- anysl/standard/text.h - text made while shading ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The host makes the text. What only makes it is `const`: it depends on its operands alone, so
// widening and the loop over the points ask once where these are the same for all points
// (standard/spaces.h). Printing is done by each point.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_TEXT_H
#define ANYSL_STANDARD_TEXT_H

#include <anysl/standard/context.h>

namespace {

[[gnu::const, gnu::noinline]] const char *appendNumbers(const AnyslShadeArgs *args,
                                                        const char *text, const char *format,
                                                        uint32_t index, uint32_t type, double x,
                                                        double y, double z) {
  AnyslCell value[3] = {{x}, {y}, {z}};
  auto append = args->services->append;
  return append ? append(args->renderer, text, format, index, type, value) : text;
}

[[gnu::const, gnu::noinline]] const char *appendString(const AnyslShadeArgs *args, const char *text,
                                                       const char *format, uint32_t index,
                                                       uint32_t type, const char *string) {
  AnyslCell value;
  value.string = string ? string : "";
  auto append = args->services->append;
  return append ? append(args->renderer, text, format, index, type, &value) : text;
}

[[gnu::const, gnu::noinline]] const char *
appendElements(const AnyslShadeArgs *args, const char *text, const char *format, uint32_t index,
               double a, double b, double c, double d, double e, double f, double g, double h,
               double i, double j, double k, double l, double m, double n, double o, double p) {
  AnyslCell value[16] = {{a}, {b}, {c}, {d}, {e}, {f}, {g}, {h},
                         {i}, {j}, {k}, {l}, {m}, {n}, {o}, {p}};
  auto append = args->services->append;
  return append ? append(args->renderer, text, format, index, ANYSL_MATRIX, value) : text;
}

[[gnu::const, gnu::noinline]] float isMatch(const AnyslShadeArgs *args, const char *pattern,
                                            const char *text) {
  auto match = args->services->match;
  return match && match(args->renderer, pattern, text) ? 1 : 0;
}

[[gnu::noinline]] void printNumbers(const AnyslShadeArgs *args, uint32_t point, const char *format,
                                    uint32_t index, uint32_t type, double x, double y, double z) {
  AnyslCell value[3] = {{x}, {y}, {z}};
  if (auto print = args->services->print_value)
    print(args->renderer, args, point, format, index, type, value);
}

[[gnu::noinline]] void printString(const AnyslShadeArgs *args, uint32_t point, const char *format,
                                   uint32_t index, uint32_t type, const char *string) {
  AnyslCell value;
  value.string = string ? string : "";
  if (auto print = args->services->print_value)
    print(args->renderer, args, point, format, index, type, &value);
}

[[gnu::noinline]] void printElements(const AnyslShadeArgs *args, uint32_t point, const char *format,
                                     uint32_t index, double a, double b, double c, double d,
                                     double e, double f, double g, double h, double i, double j,
                                     double k, double l, double m, double n, double o, double p) {
  AnyslCell value[16] = {{a}, {b}, {c}, {d}, {e}, {f}, {g}, {h},
                         {i}, {j}, {k}, {l}, {m}, {n}, {o}, {p}};
  if (auto print = args->services->print_value)
    print(args->renderer, args, point, format, index, ANYSL_MATRIX, value);
}

/// Text that no null pointer stands for.
const char *textOf(const anysl_string *text) { return *text ? *text : ""; }

/// Hands the elements of a matrix on as numbers.
template <typename Function, typename... Operands>
auto withElements(const anysl_matrix *x, Function function, Operands... operands) {
  const auto &m = x->m;
  return function(operands..., double(m[0][0]), double(m[0][1]), double(m[0][2]), double(m[0][3]),
                  double(m[1][0]), double(m[1][1]), double(m[1][2]), double(m[1][3]),
                  double(m[2][0]), double(m[2][1]), double(m[2][2]), double(m[2][3]),
                  double(m[3][0]), double(m[3][1]), double(m[3][2]), double(m[3][3]));
}

} // namespace

//===-- Making text ---------------------------------------------------------------------------===//

void anysl_append_float(anysl_string *result, anysl_context *context, const anysl_string *text,
                        const anysl_string *format, int32_t index, const anysl_float *x) {
  *result = appendNumbers(context->args, textOf(text), textOf(format), uint32_t(index), ANYSL_FLOAT,
                          double(*x), 0, 0);
}

void anysl_append_color(anysl_string *result, anysl_context *context, const anysl_string *text,
                        const anysl_string *format, int32_t index, const anysl_color *x) {
  *result = appendNumbers(context->args, textOf(text), textOf(format), uint32_t(index), ANYSL_COLOR,
                          double(x->r), double(x->g), double(x->b));
}

void anysl_append_vector(anysl_string *result, anysl_context *context, const anysl_string *text,
                         const anysl_string *format, int32_t index, const anysl_vector *x) {
  *result = appendNumbers(context->args, textOf(text), textOf(format), uint32_t(index),
                          ANYSL_VECTOR, double(x->x), double(x->y), double(x->z));
}

void anysl_append_matrix(anysl_string *result, anysl_context *context, const anysl_string *text,
                         const anysl_string *format, int32_t index, const anysl_matrix *x) {
  *result =
      withElements(x, appendElements, context->args, textOf(text), textOf(format), uint32_t(index));
}

void anysl_append_string(anysl_string *result, anysl_context *context, const anysl_string *text,
                         const anysl_string *format, int32_t index, const anysl_string *x) {
  *result = appendString(context->args, textOf(text), textOf(format), uint32_t(index), ANYSL_STRING,
                         textOf(x));
}

void anysl_append_rest(anysl_string *result, anysl_context *context, const anysl_string *text,
                       const anysl_string *format, int32_t index) {
  *result = appendString(context->args, textOf(text), textOf(format), uint32_t(index), 0, "");
}

void anysl_match(anysl_float *result, anysl_context *context, const anysl_string *pattern,
                 const anysl_string *text) {
  *result = anysl_float(isMatch(context->args, textOf(pattern), textOf(text)));
}

//===-- Printing ------------------------------------------------------------------------------===//

void anysl_print_float(anysl_context *context, const anysl_string *format, int32_t index,
                       const anysl_float *x) {
  printNumbers(context->args, context->point, textOf(format), uint32_t(index), ANYSL_FLOAT,
               double(*x), 0, 0);
}

void anysl_print_color(anysl_context *context, const anysl_string *format, int32_t index,
                       const anysl_color *x) {
  printNumbers(context->args, context->point, textOf(format), uint32_t(index), ANYSL_COLOR,
               double(x->r), double(x->g), double(x->b));
}

void anysl_print_vector(anysl_context *context, const anysl_string *format, int32_t index,
                        const anysl_vector *x) {
  printNumbers(context->args, context->point, textOf(format), uint32_t(index), ANYSL_VECTOR,
               double(x->x), double(x->y), double(x->z));
}

void anysl_print_matrix(anysl_context *context, const anysl_string *format, int32_t index,
                        const anysl_matrix *x) {
  withElements(x, printElements, context->args, context->point, textOf(format), uint32_t(index));
}

void anysl_print_string(anysl_context *context, const anysl_string *format, int32_t index,
                        const anysl_string *x) {
  printString(context->args, context->point, textOf(format), uint32_t(index), ANYSL_STRING,
              textOf(x));
}

void anysl_print_rest(anysl_context *context, const anysl_string *format, int32_t index) {
  printString(context->args, context->point, textOf(format), uint32_t(index), 0, "");
}

[[gnu::noinline]] static void tellRenderer(const AnyslShadeArgs *args, const char *text) {
  if (auto warn = args->services->warn)
    warn(args->renderer, args, text);
}

void anysl_warn(anysl_context *context, const anysl_string *text) {
  tellRenderer(context->args, textOf(text));
}

#endif // ANYSL_STANDARD_TEXT_H
