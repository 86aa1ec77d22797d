//===-- lib/Support/VerifyDiagnostics.cpp - expected messages in the source that causes them --===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/VerifyDiagnostics.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace anysl {
namespace {

struct Expectation {
  Severity severity;
  std::string file;
  unsigned line;
  unsigned count;
  StringRef text;
};

StringRef nameOf(Severity severity) {
  switch (severity) {
  case Severity::Note:
    return "note";
  case Severity::Remark:
    return "remark";
  case Severity::Warning:
    return "warning";
  case Severity::Error:
    return "error";
  }
  llvm_unreachable("unknown severity");
}

/// All `expected-…` comments of a buffer; a malformed one is reported and counts as a failure.
bool parse(StringRef name, StringRef text, std::vector<Expectation> &out, raw_ostream &errors) {
  bool ok = true;
  size_t at = 0;
  while ((at = text.find("expected-", at)) != StringRef::npos) {
    unsigned line = static_cast<unsigned>(text.take_front(at).count('\n')) + 1;
    StringRef rest = text.drop_front(at + StringRef("expected-").size());
    at += 1;
    Expectation expectation{Severity::Error, name.str(), line, 1, {}};
    if (rest.consume_front("error"))
      expectation.severity = Severity::Error;
    else if (rest.consume_front("warning"))
      expectation.severity = Severity::Warning;
    else if (rest.consume_front("note"))
      expectation.severity = Severity::Note;
    else if (rest.consume_front("remark"))
      expectation.severity = Severity::Remark;
    else
      continue; // ordinary prose
    if (rest.consume_front("@*")) {
      expectation.line = 0;
    } else if (rest.consume_front("@")) {
      bool down = rest.consume_front("-");
      bool isRelative = rest.consume_front("+") || down;
      unsigned number = 0;
      rest.consumeInteger(10, number);
      expectation.line = !isRelative ? number : down ? line - number : line + number;
    }
    rest = rest.ltrim(' ');
    rest.consumeInteger(10, expectation.count);
    rest = rest.ltrim(' ');
    size_t end = rest.find("}}");
    if (!rest.starts_with("{{") || end == StringRef::npos || rest.take_front(end).contains('\n')) {
      errors << name << ":" << line << ": expected-" << nameOf(expectation.severity)
             << " needs {{text}}\n";
      ok = false;
      continue;
    }
    expectation.text = rest.slice(2, end);
    out.push_back(expectation);
  }
  return ok;
}

} // namespace

bool verifyDiagnostics(DiagnosticEngine &engine, ArrayRef<Diagnostic> messages, raw_ostream &out) {
  std::vector<Expectation> expectations;
  bool ok = true;
  SourceMgr &sources = engine.sources();
  for (unsigned i = 1; i <= sources.getNumBuffers(); ++i)
    ok &=
        parse(sources.getMemoryBuffer(i)->getBufferIdentifier(), engine.text(i), expectations, out);

  bool wantsNotes =
      any_of(expectations, [](const Expectation &e) { return e.severity == Severity::Note; });
  std::vector<const Diagnostic *> all;
  for (const Diagnostic &message : messages) {
    all.push_back(&message);
    for (const Diagnostic &note : message.notes)
      if (wantsNotes)
        all.push_back(&note);
  }
  for (const Diagnostic *message : all) {
    // A place after #line is not where the comment stands, so the place in the text itself counts.
    FilePosition place = message->position;
    if (message->loc.isValid()) {
      unsigned buffer = sources.FindBufferContainingLoc(message->loc);
      place.file = sources.getMemoryBuffer(buffer)->getBufferIdentifier().str();
      place.line = sources.getLineAndColumn(message->loc, buffer).first;
    }
    auto fits = [&](const Expectation &e) {
      bool isHere = !e.line || (e.file == place.file && e.line == place.line);
      return e.count && isHere && e.severity == message->severity &&
             StringRef(message->message).contains(e.text);
    };
    auto found = find_if(expectations, fits);
    if (found != expectations.end()) {
      --found->count;
    } else {
      out << "not expected: " << place.file << ":" << place.line << ": "
          << nameOf(message->severity) << ": " << message->message << "\n";
      ok = false;
    }
  }
  for (const Expectation &e : expectations)
    if (e.count) {
      out << "expected but not seen: " << e.file << ":" << e.line << ": " << nameOf(e.severity)
          << ": " << e.text << "\n";
      ok = false;
    }
  return ok;
}

} // namespace anysl
