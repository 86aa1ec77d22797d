//===-- lib/Support/Diagnostics.cpp - messages that point at sources --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/Diagnostics.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include <algorithm>

using namespace llvm;

namespace anysl {

//===-- Building --------------------------------------------------------------------------------//

DiagnosticBuilder::~DiagnosticBuilder() {
  if (diagnostic)
    engine.report(std::move(*diagnostic));
}

DiagnosticBuilder &DiagnosticBuilder::range(SMLoc begin, SMLoc end) {
  if (diagnostic && begin.isValid() && end.isValid() && begin.getPointer() < end.getPointer())
    diagnostic->ranges.push_back({begin, end});
  return *this;
}

DiagnosticBuilder &DiagnosticBuilder::fixit(SMRange replaced, const Twine &text) {
  if (diagnostic && replaced.isValid())
    diagnostic->fixits.push_back(SMFixIt(replaced, text));
  return *this;
}

DiagnosticBuilder &DiagnosticBuilder::note(SMLoc loc, const Twine &message, SMRange range,
                                           bool showsLine) {
  if (!diagnostic)
    return *this;
  Diagnostic note;
  note.severity = Severity::Note;
  note.loc = loc;
  note.position = engine.presumed(loc);
  note.message = message.str();
  note.showsLine = showsLine;
  if (range.isValid())
    note.ranges.push_back(range);
  diagnostic->notes.push_back(std::move(note));
  return *this;
}

DiagnosticBuilder &DiagnosticBuilder::note(FilePosition position, const Twine &message) {
  if (!diagnostic)
    return *this;
  Diagnostic note;
  note.severity = Severity::Note;
  note.position = std::move(position);
  note.message = message.str();
  diagnostic->notes.push_back(std::move(note));
  return *this;
}

//===-- Sources ---------------------------------------------------------------------------------//

DiagnosticEngine::DiagnosticEngine(StringRef tool, raw_ostream &out) : tool(tool), out(out) {}

static std::unique_ptr<MemoryBuffer> withUnixLineEnds(StringRef text, StringRef name) {
  if (!text.contains('\r'))
    return MemoryBuffer::getMemBufferCopy(text, name);
  std::string copy;
  copy.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r')
      copy += text[i];
    else if (i + 1 == text.size() || text[i + 1] != '\n')
      copy += '\n';
  }
  return MemoryBuffer::getMemBufferCopy(copy, name);
}

Expected<unsigned> DiagnosticEngine::addFile(StringRef path, SMLoc includedFrom) {
  // A device such as /dev/zero has no end.
  sys::fs::file_status status;
  if (path != "-" && !sys::fs::status(path, status) &&
      (status.type() == sys::fs::file_type::character_file ||
       status.type() == sys::fs::file_type::block_file))
    return createStringError("it is a device");
  auto file = MemoryBuffer::getFileOrSTDIN(path, /*IsText=*/true);
  if (std::error_code code = file.getError())
    return errorCodeToError(code);
  StringRef name = path == "-" ? "<stdin>" : path;
  auto buffer = (*file)->getBuffer().contains('\r') ? withUnixLineEnds((*file)->getBuffer(), name)
                : path == "-" ? MemoryBuffer::getMemBufferCopy((*file)->getBuffer(), name)
                              : std::move(*file);
  return sourceManager.AddNewSourceBuffer(std::move(buffer), includedFrom);
}

unsigned DiagnosticEngine::addText(StringRef name, StringRef text, SMLoc includedFrom) {
  return sourceManager.AddNewSourceBuffer(withUnixLineEnds(text, name), includedFrom);
}

StringRef DiagnosticEngine::text(unsigned buffer) const {
  return sourceManager.getMemoryBuffer(buffer)->getBuffer();
}

void DiagnosticEngine::setPresumed(SMLoc loc, unsigned line, StringRef file) {
  unsigned buffer = sourceManager.FindBufferContainingLoc(loc);
  if (!buffer)
    return;
  const MemoryBuffer *memory = sourceManager.getMemoryBuffer(buffer);
  const char *next = loc.getPointer();
  while (next != memory->getBufferEnd() && *next != '\n')
    ++next;
  if (next != memory->getBufferEnd())
    ++next;
  if (lineMarks.size() <= buffer)
    lineMarks.resize(buffer + 1);
  std::vector<LineMark> &marks = lineMarks[buffer];
  std::string name = !file.empty()    ? file.str()
                     : !marks.empty() ? marks.back().file
                                      : memory->getBufferIdentifier().str();
  marks.push_back({next, line, std::move(name)});
}

void DiagnosticEngine::setExpansion(SMLoc use, StringRef macro, SMLoc definition) {
  expansions.try_emplace(use.getPointer(), Expansion{macro.str(), definition});
}

FilePosition DiagnosticEngine::presumed(SMLoc loc) const {
  if (!loc.isValid())
    return {};
  unsigned buffer = sourceManager.FindBufferContainingLoc(loc);
  if (!buffer)
    return {};
  auto [line, column] = sourceManager.getLineAndColumn(loc, buffer);
  std::string file = sourceManager.getMemoryBuffer(buffer)->getBufferIdentifier().str();
  if (buffer < lineMarks.size()) {
    const std::vector<LineMark> &marks = lineMarks[buffer];
    auto after = std::upper_bound(
        marks.begin(), marks.end(), loc.getPointer(),
        [](const char *pointer, const LineMark &mark) { return pointer < mark.from; });
    if (after != marks.begin()) {
      const LineMark &mark = *std::prev(after);
      unsigned markLine =
          sourceManager.getLineAndColumn(SMLoc::getFromPointer(mark.from), buffer).first;
      return {mark.file, mark.line + (line - markLine), column};
    }
  }
  return {std::move(file), line, column};
}

SMLoc DiagnosticEngine::locate(const FilePosition &position) {
  if (!position || !position.line)
    return {};
  auto [entry, isNew] = readFiles.try_emplace(position.file, 0);
  if (isNew) {
    for (unsigned i = 1; i <= sourceManager.getNumBuffers(); ++i)
      if (sourceManager.getMemoryBuffer(i)->getBufferIdentifier() == position.file)
        entry->second = i;
    if (!entry->second && position.file != "-") {
      // A file that is gone or was never one only costs the message its source line.
      if (Expected<unsigned> added = addFile(position.file))
        entry->second = *added;
      else
        consumeError(added.takeError());
    }
  }
  return entry->second ? sourceManager.FindLocForLineAndColumn(entry->second, position.line,
                                                               std::max(1u, position.column))
                       : SMLoc();
}

//===-- Reports ---------------------------------------------------------------------------------//

DiagnosticBuilder DiagnosticEngine::start(Severity severity, SMLoc loc, FilePosition position,
                                          const Twine &message) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.loc = loc;
  diagnostic.position = loc.isValid() ? presumed(loc) : std::move(position);
  diagnostic.message = message.str();
  return DiagnosticBuilder(*this, std::move(diagnostic));
}

DiagnosticBuilder DiagnosticEngine::error(SMLoc loc, const Twine &message) {
  return start(Severity::Error, loc, {}, message);
}

DiagnosticBuilder DiagnosticEngine::error(FilePosition position, const Twine &message) {
  return start(Severity::Error, {}, std::move(position), message);
}

bool DiagnosticEngine::isEnabled(WarningGroup group) const {
  if (noWarnings)
    return false;
  auto chosen = chosenWarnings.find(group.name);
  return chosen != chosenWarnings.end() ? chosen->second : allWarnings || group.onByDefault;
}

DiagnosticBuilder DiagnosticEngine::warning(SMLoc loc, WarningGroup group, const Twine &message) {
  if (!isEnabled(group))
    return DiagnosticBuilder(*this, std::nullopt);
  return start(warningsAsErrors ? Severity::Error : Severity::Warning, loc, {},
               message + (warningsAsErrors ? " [-Werror,-W" : " [-W") + group.name + "]");
}

DiagnosticBuilder DiagnosticEngine::warning(FilePosition position, WarningGroup group,
                                            const Twine &message) {
  if (!isEnabled(group))
    return DiagnosticBuilder(*this, std::nullopt);
  return start(warningsAsErrors ? Severity::Error : Severity::Warning, {}, std::move(position),
               message + (warningsAsErrors ? " [-Werror,-W" : " [-W") + group.name + "]");
}

DiagnosticBuilder DiagnosticEngine::remark(FilePosition position, const Twine &message) {
  return start(Severity::Remark, {}, std::move(position), message);
}

void DiagnosticEngine::report(Diagnostic diagnostic) {
  // Inlined functions and repeated includes would otherwise say the same thing many times.
  std::string key = diagnostic.position.file + ":" + utostr(diagnostic.position.line) + ":" +
                    utostr(diagnostic.position.column) + ":" + diagnostic.message;
  if (!reported.insert(key).second)
    return;
  if (auto expansion = expansions.find(diagnostic.loc.getPointer());
      expansion != expansions.end()) {
    // What should be replaced is not what stands there.
    diagnostic.fixits.clear();
    Diagnostic note;
    note.severity = Severity::Note;
    note.loc = expansion->second.definition;
    note.position = presumed(note.loc);
    note.message = "in the expansion of macro '" + expansion->second.macro + "', defined here";
    diagnostic.notes.push_back(std::move(note));
  }
  if (diagnostic.severity == Severity::Error) {
    if (reachedLimit()) {
      ++errors;
      if (!limitReported && !consumer)
        out << tool << ": too many errors, the rest is not shown\n";
      limitReported = true;
      return;
    }
    ++errors;
  } else if (diagnostic.severity == Severity::Warning) {
    ++warnings;
  }
  if (consumer)
    return consumer(diagnostic);
  print(diagnostic);
  for (const Diagnostic &note : diagnostic.notes)
    print(note);
}

void DiagnosticEngine::printIncludeStack(SMLoc loc) {
  unsigned buffer = loc.isValid() ? sourceManager.FindBufferContainingLoc(loc) : 0;
  SMLoc from = buffer ? sourceManager.getParentIncludeLoc(buffer) : SMLoc();
  if (from.getPointer() == lastIncludedFrom)
    return;
  lastIncludedFrom = from.getPointer();
  while (from.isValid()) {
    FilePosition position = presumed(from);
    out << "in file included from " << position.file << ":" << position.line << ":\n";
    from = sourceManager.getParentIncludeLoc(sourceManager.FindBufferContainingLoc(from));
  }
}

bool DiagnosticEngine::isOnLongLine(SMLoc loc) const {
  static constexpr size_t MostShown = 1000;
  unsigned buffer = sourceManager.FindBufferContainingLoc(loc);
  StringRef all = text(buffer);
  size_t place = static_cast<size_t>(loc.getPointer() - all.data());
  size_t begin = all.find_last_of("\r\n", place), end = all.find_first_of("\r\n", place);
  begin = begin == StringRef::npos ? 0 : begin;
  return std::min(end, all.size()) - begin > MostShown;
}

void DiagnosticEngine::print(const Diagnostic &diagnostic) {
  SourceMgr::DiagKind kind = SourceMgr::DK_Error;
  switch (diagnostic.severity) {
  case Severity::Note:
    kind = SourceMgr::DK_Note;
    break;
  case Severity::Remark:
    kind = SourceMgr::DK_Remark;
    break;
  case Severity::Warning:
    kind = SourceMgr::DK_Warning;
    break;
  case Severity::Error:
    kind = SourceMgr::DK_Error;
    break;
  }
  const FilePosition &position = diagnostic.position;
  SMLoc loc = !diagnostic.showsLine      ? SMLoc()
              : diagnostic.loc.isValid() ? diagnostic.loc
                                         : locate(position);
  if (!loc.isValid() || isOnLongLine(loc)) {
    std::string place = position ? position.file : tool;
    if (position && position.line)
      place += ":" + utostr(position.line);
    if (position && position.line && position.column)
      place += ":" + utostr(position.column);
    SMDiagnostic(place, kind, diagnostic.message).print(nullptr, out);
    return;
  }
  printIncludeStack(loc);
  // GetMessage cuts out the source line and maps ranges to columns; only the presumed file and line
  // differ from what it assumes.
  SMDiagnostic plain =
      sourceManager.GetMessage(loc, kind, diagnostic.message, diagnostic.ranges, diagnostic.fixits);
  SMDiagnostic shown(sourceManager, loc, position.file, static_cast<int>(position.line),
                     plain.getColumnNo(), kind, diagnostic.message, plain.getLineContents(),
                     plain.getRanges(), diagnostic.fixits);
  shown.print(nullptr, out);
}

void DiagnosticEngine::printSummary() {
  if (!errors && !warnings)
    return;
  if (errors)
    out << errors << (errors == 1 ? " error" : " errors");
  if (warnings)
    out << (errors ? " and " : "") << warnings << (warnings == 1 ? " warning" : " warnings");
  out << " generated.\n";
}

//===-- Suggestions -----------------------------------------------------------------------------//

std::optional<StringRef> suggest(StringRef name, ArrayRef<StringRef> candidates) {
  unsigned best = static_cast<unsigned>(name.size() + 2) / 3;
  std::optional<StringRef> found;
  for (StringRef candidate : candidates) {
    if (candidate == name || candidate.empty())
      continue;
    // A letter's case alone is the likeliest slip of all.
    unsigned distance = candidate.equals_insensitive(name)
                            ? 0
                            : name.edit_distance(candidate, /*AllowReplacements=*/true, best);
    if (distance < best || (distance == best && !found)) {
      best = distance;
      found = candidate;
    }
  }
  // Two different one-letter names are no misspelling of each other.
  if (found && name.size() < 2 && !found->equals_insensitive(name))
    return std::nullopt;
  return found;
}

std::string didYouMean(StringRef name, ArrayRef<StringRef> candidates) {
  std::optional<StringRef> found = suggest(name, candidates);
  return found ? "; did you mean '" + found->str() + "'?" : std::string();
}

} // namespace anysl
