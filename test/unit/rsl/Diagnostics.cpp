//===-- test/unit/rsl/Diagnostics.cpp - messages with their source lines ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/Diagnostics.h"
#include "lib/Support/VerifyDiagnostics.h"
#include <catch2/catch.hpp>

using namespace llvm;
using namespace anysl;

namespace {

struct Fixture {
  std::string output;
  raw_string_ostream stream{output};
  DiagnosticEngine diags{"tool", stream};
  unsigned buffer = diags.addText("file.sl", "one two\nthree four\nfive\n");

  SMLoc loc(size_t offset) { return SMLoc::getFromPointer(diags.text(buffer).data() + offset); }
};

} // namespace

TEST_CASE_METHOD(Fixture, "an error shows its line, range, fix and notes") {
  diags.error(loc(8), "bad word")
      .range(loc(8), loc(13))
      .fixit({loc(8), loc(13)}, "3")
      .note(loc(4), "see here");
  CHECK(stream.str() == "file.sl:2:1: error: bad word\nthree four\n^~~~~\n3\n"
                        "file.sl:1:5: note: see here\none two\n    ^\n");
  CHECK(diags.errorCount() == 1);
}

TEST_CASE_METHOD(Fixture, "a message without a place names the tool") {
  diags.error("no input");
  CHECK(stream.str() == "tool: error: no input\n");
}

TEST_CASE_METHOD(Fixture, "a place from elsewhere is shown with its line if the file is known") {
  diags.error(FilePosition{"file.sl", 3, 2}, "here");
  diags.error(FilePosition{"/nonexistent/gone.sl", 7, 4}, "there");
  diags.error(FilePosition{"whole.sl"}, "all of it");
  CHECK(stream.str() == "file.sl:3:2: error: here\nfive\n ^\n"
                        "/nonexistent/gone.sl:7:4: error: there\nwhole.sl: error: all of it\n");
}

TEST_CASE_METHOD(Fixture, "#line changes the place that is shown") {
  diags.setPresumed(loc(0), 100, "other.sl");
  CHECK(diags.presumed(loc(0)).line == 1);
  CHECK(diags.presumed(loc(8)).line == 100);
  CHECK(diags.presumed(loc(19)).line == 101);
  CHECK(diags.presumed(loc(19)).file == "other.sl");
  diags.error(loc(19), "late");
  CHECK(stream.str() == "other.sl:101:1: error: late\nfive\n^\n");
}

TEST_CASE_METHOD(Fixture, "the same message at the same place is given once") {
  diags.error(loc(0), "again");
  diags.error(loc(0), "again");
  diags.error(loc(4), "again");
  CHECK(diags.errorCount() == 2);
}

TEST_CASE_METHOD(Fixture, "errors beyond the limit are counted, not shown") {
  diags.setErrorLimit(2);
  for (size_t i = 0; i < 5; ++i)
    diags.error(loc(i), "error");
  CHECK(diags.errorCount() == 5);
  CHECK(diags.reachedLimit());
  CHECK(StringRef(stream.str()).count("error: error") == 2);
  CHECK(StringRef(stream.str()).contains("too many errors"));
}

TEST_CASE_METHOD(Fixture, "warnings can be chosen, silenced and made errors") {
  constexpr WarningGroup on{"loud", true}, off{"quiet", false};
  diags.warning(loc(0), on, "a");
  diags.warning(loc(0), off, "b").note(loc(1), "not shown");
  CHECK(diags.warningCount() == 1);
  diags.setAllWarnings(true);
  diags.setWarning("loud", false);
  diags.warning(loc(0), on, "c");
  diags.warning(loc(0), off, "d");
  CHECK(diags.warningCount() == 2);
  diags.setWarningsAsErrors(true);
  diags.warning(loc(0), off, "e");
  CHECK(diags.errorCount() == 1);
  CHECK(StringRef(stream.str()).contains("error: e [-Werror,-Wquiet]"));
  diags.setNoWarnings(true);
  diags.warning(loc(0), off, "f");
  CHECK(diags.errorCount() == 1);
  diags.printSummary();
  CHECK(StringRef(stream.str()).ends_with("1 error and 2 warnings generated.\n"));
}

TEST_CASE("line ends of every kind count as one") {
  DiagnosticEngine diags("tool", nulls());
  unsigned buffer = diags.addText("x", "a\rb\r\nc\n\rd");
  CHECK(diags.text(buffer) == "a\nb\nc\n\nd");
}

TEST_CASE("suggestions are near misses only") {
  StringRef names[] = {"normalize", "noise", "ambient", "s", "Cs"};
  CHECK(suggest("noramlize", names) == StringRef("normalize"));
  CHECK(suggest("Noise", names) == StringRef("noise"));
  CHECK(suggest("cs", names) == StringRef("Cs"));
  CHECK(suggest("ambience", names) == StringRef("ambient"));
  CHECK_FALSE(suggest("x", names));
  CHECK_FALSE(suggest("specular", names));
  CHECK(didYouMean("nois", names) == "; did you mean 'noise'?");
  CHECK(didYouMean("zzz", names).empty());
}

TEST_CASE("expected messages are held against what was said") {
  auto run = [](StringRef text, bool sayIt) {
    DiagnosticEngine diags("tool", nulls());
    std::vector<Diagnostic> messages;
    diags.setConsumer([&](const Diagnostic &message) { messages.push_back(message); });
    unsigned buffer = diags.addText("x.sl", text);
    if (sayIt)
      diags.error(SMLoc::getFromPointer(diags.text(buffer).data()), "something is wrong");
    return verifyDiagnostics(diags, messages, nulls());
  };
  CHECK(run("x // expected-error {{is wrong}}", true));
  CHECK(run("x\n// expected-error@-1 {{is wrong}}", true));
  CHECK(run("x\n// expected-error@1 {{is wrong}}", true));
  CHECK(run("x\n// expected-error@* {{is wrong}}", true));
  CHECK_FALSE(run("x // expected-error {{is wrong}}", false));
  CHECK_FALSE(run("x // expected-error {{is right}}", true));
  CHECK_FALSE(run("x // expected-warning {{is wrong}}", true));
  CHECK_FALSE(run("x // expected-error 2 {{is wrong}}", true));
  CHECK_FALSE(run("x // expected-error is wrong", true));
  CHECK_FALSE(run("x", true));
  CHECK(run("what is expected-ly fine", false));
}
