//===-- tools/stc-reference/stc-reference.cpp - prints the page of operators --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Prints docs/stc-reference.md from the tables of lib/STC and <anysl/Globals.def>.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Shader.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;
using namespace anysl::stc;

namespace {

/// A `|` would end the table's cell.
std::string cell(StringRef text) {
  std::string result;
  for (char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string parameterList(const OpInfo &op) {
  std::string result;
  for (const OpParam &param : op.params)
    result += (result.empty() ? "" : ", ") + toString(param);
  return result;
}

void printTypes(raw_ostream &out) {
  out << "## Types\n\n| id | type | symbol | components | meaning |\n|---|---|---|---|---|\n";
  for (const TypeInfo &type : allTypes())
    out << "| " << unsigned(type.type) << " | `" << type.name << "` | `@" << typeSymbolPrefix
        << type.name << "` | " << type.components << " | " << type.doc << " |\n";
}

void printGlobals(raw_ostream &out) {
  out << "\n## Shader globals\n\n"
         "| id | name | type | storage | by u, by v | meaning |\n|---|---|---|---|---|---|\n";
  for (const GlobalVariableInfo &global : allGlobals()) {
    out << "| " << global.id << " | `" << global.name << "` | `" << info(global.type).name << "` | "
        << nameOf(global.storage) << " |";
    ListSeparator separator(",");
    for (unsigned id : derivativesOf(global.id))
      out << separator << " `" << globalNumbered(id)->name << '`';
    out << " | " << global.doc << (global.isHidden ? " (hidden)" : "") << " |\n";
  }
}

void printEffectsAndServices(raw_ostream &out) {
  out << "\n## Effects\n\n| id | effect | meaning |\n|---|---|---|\n";
#define STC_EFFECT(id, name, doc) out << "| " #id " | " #name " | " doc " |\n";
#include "lib/STC/Effects.def"
  out << "\n## Services\n\nWhat an operator asks of the renderer.\n\n"
         "| id | service | meaning |\n|---|---|---|\n";
#define STC_SERVICE(id, name, doc) out << "| " #id " | " #name " | " doc " |\n";
#include "lib/STC/Services.def"
}

void printOperators(raw_ostream &out) {
  out << "\n## Operators\n\n"
         "| id | operator | result | parameters | meaning | purity | rule | effect | service |\n"
         "|---|---|---|---|---|---|---|---|---|\n";
  for (const OpInfo &op : allOps())
    out << "| " << op.id() << " | `" << op.symbol() << "` | "
        << (op.result == ResultKind::None ? StringRef("–") : nameOf(op.result)) << " | `"
        << parameterList(op) << "` | " << cell(op.doc) << " | " << nameOf(op.purity) << " | "
        << nameOf(op.rule) << " | " << nameOf(op.effect) << " | "
        << (op.service == Service::NoService ? StringRef("–") : nameOf(op.service)) << " |\n";
}

void printNeutral(raw_ostream &out) {
  out << "\n## Operators that a renderer may decline\n\n"
         "Where neither the runtime nor the shading library defines one of these, every output is "
         "the value,\nin each component, and `anysl-link` warns at the shader's line; with "
         "`--decline=error` it is an error.\n\n"
         "| operator | value | that is |\n|---|---|---|\n";
#define STC_NEUTRAL(name, value, meaning)                                                          \
  out << "| `anysl_" #name "` | " #value " | " meaning " |\n";
#include "lib/STC/Neutral.def"
}

} // namespace

int main() {
  raw_ostream &out = outs();
  out << "# Reference of subroutine-threaded code\n\n"
         "Version "
      << stcVersion
      << ". Printed by `stc-reference` from `lib/STC/*.def` and `include/anysl/Globals.def`; after "
         "a\n"
         "change of those, `ninja stc-docs` writes it anew. What the columns mean stands at the "
         "head\n"
         "of `lib/STC/StcOps.def`, what a module looks like in `docs/architecture.md`.\n\n";
  printTypes(out);
  printGlobals(out);
  printEffectsAndServices(out);
  printOperators(out);
  printNeutral(out);
}
