/*===-- anysl/notes.h - what a shader library notes of its own computation ---------------*- C
 *-*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===
 *
 * A library linked with --check-nan says where a number stopped being finite, one linked with
 * --max-loop which loops it has left, and one linked with
 * the real `interval` says which branches its bounds do not decide and what bounds its results have
 * (docs/numerics.md). One that anysl-cost has linked to look for lost digits says what each
 *operator does. Other libraries note nothing, and nothing of this is in them.
 *
 *     static void print(void *data, const AnyslNote *note) { ... }
 *     anysl_library_note(library, print, NULL);
 *
 *===--------------------------------------------------------------------------------------------===*/

#ifndef ANYSL_NOTES_H
#define ANYSL_NOTES_H

#include <anysl/abi.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum AnyslNoteKind {
  /** An operator whose operands are finite, or which has none, gave NaN or infinity. */
  ANYSL_NOTE_NOT_FINITE = 1,
  /** A condition that the bounds of its operands do not decide; it was decided by their middles. */
  ANYSL_NOTE_UNDECIDED,
  /** The bounds of a result of the shader. */
  ANYSL_NOTE_BOUNDS,
  /** What an operator gave; one note for each value that it writes. */
  ANYSL_NOTE_VALUE,
  /** What a condition, or an index into an array, came to. */
  ANYSL_NOTE_DECISION,
  /** A value that becomes a result of the shader. */
  ANYSL_NOTE_STORE,
  /** A loop that has been left because it had run as many rounds as --max-loop allows. */
  ANYSL_NOTE_LOOP_LIMIT
} AnyslNoteKind;

/** At most so many numbers are noted of the results of an operator, and of its operands. */
enum { ANYSL_NOTE_RESULTS = 4, ANYSL_NOTE_OPERANDS = 12 };

/** A place in a shader. */
typedef struct AnyslNoteSite {
  uint32_t kind; /**< AnyslNoteKind */
  uint32_t line;
  uint32_t column;
  uint32_t result_count;  /**< numbers in AnyslNote::results */
  uint32_t operand_count; /**< numbers in AnyslNote::operands */
  uint32_t reserved;
  const char *shader;
  const char *file; /**< as rslc was given it */
  const char
      *op; /**< the operator's name in STC: "sqrt"; for BOUNDS and STORE the result's: "Ci" */
} AnyslNoteSite;

typedef struct AnyslNote {
  uint32_t struct_size;
  uint32_t point; /**< its number in the batch */
  const AnyslNoteSite *site;
  const struct AnyslShadeArgs *args;
  /** All components of the results, one result after the other; of UNDECIDED the condition as it
      was decided, 0 or 1; of LOOP_LIMIT the number of rounds. Of BOUNDS the lower bounds of the
     components. */
  const double *results;
  /** All components of the operands as they were before. Of BOUNDS the upper bounds. Of VALUE,
      DECISION and STORE addresses, by which one finds who computed what: that of the value written
      (of VALUE only), then those of the values read. */
  const double *operands;
} AnyslNote;

/** Called while shading, by whichever thread shades. */
typedef void AnyslNoteHandler(void *data, const AnyslNote *note);

/** What such a library has under the symbol ANYSL_NOTES_SYMBOL. */
typedef struct AnyslNoteHook {
  AnyslNoteHandler *handle;
  void *data;
} AnyslNoteHook;

#define ANYSL_NOTES_SYMBOL "anysl_notes"
#define ANYSL_NOTES_API __attribute__((visibility("default")))

struct AnyslLibrary;

/**
 * Sets who is told of a library's notes; null: nobody, as at first. Not while some thread shades
 * with the library. Gives 0, and does nothing, if the library notes nothing.
 */
ANYSL_NOTES_API int anysl_library_note(const struct AnyslLibrary *library, AnyslNoteHandler *handle,
                                       void *data);

/**
 * A note as a sentence, "wood.sl:3:7: sqrt(-1) is nan, in shader 'wood' at point 17", written to
 * \p text as snprintf() would. The first point of a batch is called number \p first. Returns the
 * sentence's length.
 */
ANYSL_NOTES_API size_t anysl_note_text(const AnyslNote *note, uint64_t first, char *text,
                                       size_t size);

/** Collects notes: of each place the first one and how many there were. Those of which every point
   has some (BOUNDS, VALUE, DECISION, STORE) are passed over. */
typedef struct AnyslNoteLog AnyslNoteLog;

/** Collects a library's notes from now on; null if it notes nothing. */
ANYSL_NOTES_API AnyslNoteLog *anysl_note_log_create(const struct AnyslLibrary *library);
/** Counts points from \p first on in sentences: what the first point of a batch is to be called.
   Not while some thread shades. */
ANYSL_NOTES_API void anysl_note_log_count_from(AnyslNoteLog *log, uint64_t first);
/** Ends that. */
ANYSL_NOTES_API void anysl_note_log_free(AnyslNoteLog *log);
/** The \p index-th of the places so far, in the order of files, lines and columns: the sentence of
   its first note, valid until the log is freed; null behind the last. \p count (may be null) is
   set to how many notes there were. Not while some thread shades. */
ANYSL_NOTES_API const char *anysl_note_log_entry(AnyslNoteLog *log, size_t index, uint64_t *count);

#ifdef __cplusplus
}
#endif

#endif
