//===-- lib/Host/Notes.cpp - what libraries note of their own computation ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <anysl/notes.h>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <map>
#include <mutex>
#include <string_view>
#include <tuple>

using namespace anysl::host;

namespace {

/// Numbers with commas between; shortly, as a person reads them.
std::string list(const double *numbers, uint32_t count) {
  std::string text;
  char buffer[32];
  for (uint32_t i = 0; i < count; ++i) {
    std::snprintf(buffer, sizeof buffer, "%s%.9g", i ? ", " : "", numbers[i]);
    text += buffer;
  }
  return text;
}

std::string parenthesized(const double *numbers, uint32_t count) {
  return count == 1 ? list(numbers, 1) : "(" + list(numbers, count) + ")";
}

std::string sentence(const AnyslNote &note, uint64_t first) {
  const AnyslNoteSite &site = *note.site;
  std::string text = std::string(site.file) + ":" + std::to_string(site.line) + ":" +
                     std::to_string(site.column) + ": " + site.op;
  std::string operands = list(note.operands, site.operand_count);
  switch (site.kind) {
  case ANYSL_NOTE_NOT_FINITE:
    text += (site.operand_count ? "(" + operands + ")" : "") + " is " +
            parenthesized(note.results, site.result_count);
    break;
  case ANYSL_NOTE_UNDECIDED:
    text += "(" + operands + ") is not decided, and taken as " + list(note.results, 1);
    break;
  case ANYSL_NOTE_BOUNDS:
    text += " is from " + parenthesized(note.results, site.result_count) + " to " +
            parenthesized(note.operands, site.operand_count);
    break;
  case ANYSL_NOTE_VALUE:
  case ANYSL_NOTE_DECISION:
  case ANYSL_NOTE_STORE:
    text += " is " + parenthesized(note.results, site.result_count);
    break;
  case ANYSL_NOTE_LOOP_LIMIT:
    text += " left after " + list(note.results, 1) + " rounds";
    break;
  }
  return text + ", in shader '" + site.shader + "' at point " + std::to_string(first + note.point);
}

/// Such notes are no news.
bool isOfEveryPoint(uint32_t kind) { return kind >= ANYSL_NOTE_BOUNDS && kind <= ANYSL_NOTE_STORE; }

/// Places by what is printed of them first; one place has several notes if it computes several
/// things.
struct PlaceOrder {
  bool operator()(const AnyslNoteSite *a, const AnyslNoteSite *b) const {
    auto key = [](const AnyslNoteSite &site) {
      return std::tuple(std::string_view(site.file), site.line, site.column, site.kind,
                        std::string_view(site.op), std::string_view(site.shader));
    };
    return key(*a) < key(*b);
  }
};

} // namespace

struct AnyslNoteLog {
  struct Entry {
    std::string text;
    uint64_t count = 0;
  };

  LibraryRef library;
  uint64_t first = 0;
  std::mutex lock;
  std::map<const AnyslNoteSite *, Entry, PlaceOrder> entries;
};

extern "C" {

int anysl_library_note(const AnyslLibrary *library, AnyslNoteHandler *handle, void *data) {
  void *file = library->loaded->handle;
  void *hook = file ? dlsym(file, ANYSL_NOTES_SYMBOL) : nullptr;
  if (!hook)
    return 0;
  *static_cast<AnyslNoteHook *>(hook) = {handle, data};
  return 1;
}

size_t anysl_note_text(const AnyslNote *note, uint64_t first, char *text, size_t size) {
  return size_t(std::snprintf(text, size, "%s", sentence(*note, first).c_str()));
}

AnyslNoteLog *anysl_note_log_create(const AnyslLibrary *library) {
  auto *log = new AnyslNoteLog;
  log->library = library->loaded;
  auto add = [](void *data, const AnyslNote *note) {
    auto &log = *static_cast<AnyslNoteLog *>(data);
    if (isOfEveryPoint(note->site->kind))
      return;
    std::lock_guard guard(log.lock);
    AnyslNoteLog::Entry &entry = log.entries[note->site];
    if (++entry.count == 1)
      entry.text = sentence(*note, log.first);
  };
  if (anysl_library_note(library, add, log))
    return log;
  delete log;
  return nullptr;
}

void anysl_note_log_count_from(AnyslNoteLog *log, uint64_t first) { log->first = first; }

void anysl_note_log_free(AnyslNoteLog *log) {
  if (!log)
    return;
  AnyslLibrary library{log->library};
  anysl_library_note(&library, nullptr, nullptr);
  delete log;
}

const char *anysl_note_log_entry(AnyslNoteLog *log, size_t index, uint64_t *count) {
  if (index >= log->entries.size())
    return nullptr;
  auto entry = std::next(log->entries.begin(), std::ptrdiff_t(index));
  if (count)
    *count = entry->second.count;
  return entry->second.text.c_str();
}
}
