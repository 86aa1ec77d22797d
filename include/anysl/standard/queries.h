//===-- anysl/standard/queries.h - what shaders ask for by name -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// An answer that is the same for all points of a batch comes from a `const` function, so that
// widening and the loop over the points ask once (standard/spaces.h); any other is asked for point
// by point. Both give four numbers at a time: row 0 is whether there is an answer, and the
// components of a float or a triple; rows 1 to 4 are those of a matrix.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_QUERIES_H
#define ANYSL_STANDARD_QUERIES_H

#include <anysl/standard/context.h>

namespace {

using AnswerRow = double __attribute__((ext_vector_type(4)));

/// What an operator asks for, but its variable's type.
struct Question {
  uint32_t kind, number;
  const char *subject, *name;
  uint32_t arrayLength, element;
};

/// Whether the answers of a kind differ from point to point. To be called with a constant.
constexpr bool isVarying(uint32_t kind) {
#define uniform false
#define varying true
#define ANYSL_QUERY(id, name, storage, doc)                                                        \
  if (kind == id)                                                                                  \
    return storage;
#include <anysl/QueryKinds.def>
#undef uniform
#undef varying
  return true;
}

/// Asks the renderer, and gives a row of its answer.
inline AnswerRow rowOf(const AnyslShadeArgs *args, uint32_t point, const AnyslQuery &query,
                       uint32_t row) {
  AnyslCell value[16] = {};
  auto ask = args->services->query;
  bool known = ask && ask(args->renderer, args, point, &query, value);
  if (row == 0)
    return {known ? 1.0 : 0.0, value[0].number, value[1].number, value[2].number};
  const AnyslCell *cells = value + (row - 1) * 4;
  return {cells[0].number, cells[1].number, cells[2].number, cells[3].number};
}

inline const char *textAnswer(const AnyslShadeArgs *args, uint32_t point, const AnyslQuery &query) {
  AnyslCell value;
  value.string = "";
  auto ask = args->services->query;
  bool known = ask && ask(args->renderer, args, point, &query, &value);
  return known ? (value.string ? value.string : "") : nullptr;
}

//===-- Asked for a batch ---------------------------------------------------------------------===//

[[gnu::const, gnu::noinline]] AnswerRow
askBatch(const AnyslShadeArgs *args, uint32_t kind, uint32_t number, const char *subject,
         const char *name, uint32_t type, uint32_t arrayLength, uint32_t element, uint32_t row) {
  AnyslQuery query = {kind, type, arrayLength, element, number, 0, name, subject};
  return rowOf(args, 0, query, row);
}

/// Null where there is no answer.
[[gnu::const, gnu::noinline]] const char *askBatchForText(const AnyslShadeArgs *args, uint32_t kind,
                                                          uint32_t number, const char *subject,
                                                          const char *name, uint32_t arrayLength,
                                                          uint32_t element) {
  AnyslQuery query = {kind, ANYSL_STRING, arrayLength, element, number, 0, name, subject};
  return textAnswer(args, 0, query);
}

//===-- Asked for a point ---------------------------------------------------------------------===//

[[gnu::noinline]] void askPoint(const AnyslShadeArgs *args, uint32_t point, uint32_t kind,
                                uint32_t number, const char *subject, const char *name,
                                uint32_t type, uint32_t arrayLength, uint32_t element, uint32_t row,
                                double *a, double *b, double *c, double *d) {
  AnyslQuery query = {kind, type, arrayLength, element, number, 0, name, subject};
  AnswerRow answer = rowOf(args, point, query, row);
  *a = answer.x, *b = answer.y, *c = answer.z, *d = answer.w;
}

[[gnu::noinline]] const char *askPointForText(const AnyslShadeArgs *args, uint32_t point,
                                              uint32_t kind, uint32_t number, const char *subject,
                                              const char *name, uint32_t arrayLength,
                                              uint32_t element) {
  AnyslQuery query = {kind, ANYSL_STRING, arrayLength, element, number, 0, name, subject};
  return textAnswer(args, point, query);
}

//===-- Either --------------------------------------------------------------------------------===//

/// Four numbers of an answer; no vector, which could differ from lane to lane.
struct Answer {
  double a, b, c, d;
};

inline void ask(Answer &answer, const anysl_context *context, const Question &q, uint32_t type,
                uint32_t row) {
  if (isVarying(q.kind)) {
    askPoint(context->args, context->point, q.kind, q.number, q.subject, q.name, type,
             q.arrayLength, q.element, row, &answer.a, &answer.b, &answer.c, &answer.d);
    return;
  }
  AnswerRow given = askBatch(context->args, q.kind, q.number, q.subject, q.name, type,
                             q.arrayLength, q.element, row);
  answer.a = given.x, answer.b = given.y, answer.c = given.z, answer.d = given.w;
}

/// An array of any length, for one point: `f*64` says what it is.
[[gnu::noinline]] bool askArray(const AnyslShadeArgs *args, uint32_t point, uint32_t kind,
                                const char *subject, const char *name, const char *shape,
                                anysl_float *numbers, uint32_t numberCount, anysl_string *texts,
                                uint32_t textCount) {
  auto ask = args->services->query;
  uint32_t type = shape[0] == 'f'   ? ANYSL_FLOAT
                  : shape[0] == 't' ? ANYSL_VECTOR
                  : shape[0] == 'm' ? ANYSL_MATRIX
                                    : ANYSL_STRING;
  uint32_t components = type == ANYSL_FLOAT ? 1 : type == ANYSL_MATRIX ? 16 : 3;
  if (!ask || numberCount == 0)
    return false;
  uint32_t room = type == ANYSL_STRING ? textCount : (numberCount - 1) / components, count = 0;
  for (; count < room; ++count) {
    AnyslQuery query = {kind, type, ANYSL_ANY_LENGTH, count, 0, 0, name, subject};
    AnyslCell value[16] = {};
    if (!ask(args->renderer, args, isVarying(kind) ? point : 0, &query, value))
      break;
    if (type == ANYSL_STRING)
      texts[count] = value[0].string ? value[0].string : "";
    else
      for (uint32_t c = 0; c < components; ++c)
        numbers[1 + count * components + c] = anysl_float(value[c].number);
  }
  if (count)
    numbers[0] = anysl_float(double(count));
  return count > 0;
}

inline void keepOr(bool known, anysl_float &x, double answer) {
  x = anysl::select(known, anysl_float(answer), x);
}

inline const char *nameIn(const anysl_string *text) { return *text ? *text : ""; }

} // namespace

bool anysl_query_float(anysl_context *context, uint32_t kind, int32_t number,
                       const anysl_string *subject, const anysl_string *name, uint32_t arrayLength,
                       uint32_t element, anysl_float *x) {
  Question q = {kind, uint32_t(number), nameIn(subject), nameIn(name), arrayLength, element};
  Answer answer;
  ask(answer, context, q, ANYSL_FLOAT, 0);
  bool known = answer.a != 0;
  keepOr(known, *x, answer.b);
  return known;
}

bool anysl_query_color(anysl_context *context, uint32_t kind, int32_t number,
                       const anysl_string *subject, const anysl_string *name, uint32_t arrayLength,
                       uint32_t element, anysl_color *x) {
  Question q = {kind, uint32_t(number), nameIn(subject), nameIn(name), arrayLength, element};
  Answer answer;
  ask(answer, context, q, ANYSL_COLOR, 0);
  bool known = answer.a != 0;
  keepOr(known, x->r, answer.b);
  keepOr(known, x->g, answer.c);
  keepOr(known, x->b, answer.d);
  return known;
}

bool anysl_query_vector(anysl_context *context, uint32_t kind, int32_t number,
                        const anysl_string *subject, const anysl_string *name, uint32_t arrayLength,
                        uint32_t element, anysl_vector *x) {
  Question q = {kind, uint32_t(number), nameIn(subject), nameIn(name), arrayLength, element};
  Answer answer;
  ask(answer, context, q, ANYSL_VECTOR, 0);
  bool known = answer.a != 0;
  keepOr(known, x->x, answer.b);
  keepOr(known, x->y, answer.c);
  keepOr(known, x->z, answer.d);
  return known;
}

bool anysl_query_matrix(anysl_context *context, uint32_t kind, int32_t number,
                        const anysl_string *subject, const anysl_string *name, uint32_t arrayLength,
                        uint32_t element, anysl_matrix *x) {
  Question q = {kind, uint32_t(number), nameIn(subject), nameIn(name), arrayLength, element};
  Answer answer;
  ask(answer, context, q, ANYSL_MATRIX, 0);
  bool known = answer.a != 0;
  anysl::repeat<4>([&](auto row) {
    Answer elements;
    ask(elements, context, q, ANYSL_MATRIX, uint32_t(int(row)) + 1);
    keepOr(known, x->m[row][0], elements.a);
    keepOr(known, x->m[row][1], elements.b);
    keepOr(known, x->m[row][2], elements.c);
    keepOr(known, x->m[row][3], elements.d);
  });
  return known;
}

bool anysl_query_string(anysl_context *context, uint32_t kind, int32_t number,
                        const anysl_string *subject, const anysl_string *name, uint32_t arrayLength,
                        uint32_t element, anysl_string *x) {
  const char *about = nameIn(subject), *asked = nameIn(name);
  const char *answer = isVarying(kind)
                           ? askPointForText(context->args, context->point, kind, uint32_t(number),
                                             about, asked, arrayLength, element)
                           : askBatchForText(context->args, kind, uint32_t(number), about, asked,
                                             arrayLength, element);
  *x = answer ? answer : *x;
  return answer != nullptr;
}

bool anysl_query_array(anysl_context *context, uint32_t kind, const anysl_string *subject,
                       const anysl_string *name, const anysl_string *shape, anysl_float *numbers,
                       uint32_t numberCount, anysl_string *texts, uint32_t textCount) {
  return askArray(context->args, context->point, kind, nameIn(subject), nameIn(name), nameIn(shape),
                  numbers, numberCount, texts, textCount);
}

#endif // ANYSL_STANDARD_QUERIES_H
