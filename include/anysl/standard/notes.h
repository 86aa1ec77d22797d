//===-- anysl/standard/notes.h - telling a host what happened at a point ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The linker puts calls of anysl_note behind operators where notes are asked for
// (lib/Link/Notes.cpp); otherwise nothing of this is linked.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_NOTES_H
#define ANYSL_STANDARD_NOTES_H

#include <anysl/notes.h>
#include <anysl/standard/context.h>

extern "C" {

/// Set by the host; the library exports it.
AnyslNoteHook anysl_notes;

/// Called by the shader with results a to d and operands e to p, as many of them as the site says.
void anysl_note(anysl_context *context, const AnyslNoteSite *site, double a, double b, double c,
                double d, double e, double f, double g, double h, double i, double j, double k,
                double l, double m, double n, double o, double p);
}

namespace anysl {

__attribute__((noinline)) inline void tellHost(const AnyslShadeArgs *args, uint32_t point,
                                               const AnyslNoteSite *site, double a, double b,
                                               double c, double d, double e, double f, double g,
                                               double h, double i, double j, double k, double l,
                                               double m, double n, double o, double p) {
  if (!anysl_notes.handle)
    return;
  double results[] = {a, b, c, d}, operands[] = {e, f, g, h, i, j, k, l, m, n, o, p};
  static_assert(sizeof results == ANYSL_NOTE_RESULTS * sizeof(double));
  static_assert(sizeof operands == ANYSL_NOTE_OPERANDS * sizeof(double));
  AnyslNote note = {sizeof(AnyslNote), point, site, args, results, operands};
  anysl_notes.handle(anysl_notes.data, &note);
}

} // namespace anysl

void anysl_note(anysl_context *context, const AnyslNoteSite *site, double a, double b, double c,
                double d, double e, double f, double g, double h, double i, double j, double k,
                double l, double m, double n, double o, double p) {
  anysl::tellHost(context->args, context->point, site, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o,
                  p);
}

#endif // ANYSL_STANDARD_NOTES_H
