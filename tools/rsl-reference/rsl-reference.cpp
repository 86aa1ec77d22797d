//===-- tools/rsl-reference/rsl-reference.cpp - prints the page of built-ins ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Prints docs/rsl-builtins.md from frontends/rsl/Builtins.def.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Builtins.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;
using namespace anysl;

namespace {

/// A `|` would end the table's cell.
std::string cell(StringRef text) {
  std::string result;
  for (char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

void printBuiltins(raw_ostream &out) {
  out << "| built-in | operator | meaning |\n|---|---|---|\n";
  for (const rsl::Builtin &builtin : rsl::allBuiltins()) {
    // Names with two underscores are for the shading library.
    if (!builtin.name.starts_with("__"))
      out << "| `" << rsl::signature(builtin) << "` | `" << stc::info(builtin.op).name << "` | "
          << cell(builtin.meaning) << " |\n";
  }
}

void printSpecials(raw_ostream &out) {
  out << "\n## With arguments of their own\n\n| built-in | meaning |\n|---|---|\n";
#define RSL_SPECIAL(result, name, arguments, meaning)                                              \
  out << "| `" << (StringRef(#result) == "condition" ? "" : #result " ") << #name arguments "` | " \
      << cell(meaning) << " |\n";
#include "frontends/rsl/Builtins.def"
}

void printNamed(raw_ostream &out) {
  out << "\n## Arguments by name\n\n"
         "What stands for `...` above: pairs of a name, which is constant text, and a value. A "
         "type "
         "may stand "
         "before the name, `\"uniform float blur\"`. Arguments that mean nothing here are "
         "accepted; "
         "one that is "
         "not listed is ignored with a warning (`-Wno-unknown-argument` silences it). What a "
         "renderer "
         "may decline "
         "(lib/STC/Neutral.def) takes any arguments.\n";
  for (const rsl::NamedGroup &group : rsl::namedGroups()) {
    if (none_of(rsl::allBuiltins(), [&](const auto &builtin) { return builtin.named == &group; }))
      continue;
    out << "\n| " << group.name << " | type | meaning |\n|---|---|---|\n";
    for (const rsl::NamedGroup::Argument &argument : group.arguments)
      out << "| `\"" << argument.name << "\"` | " << rsl::nameOf(argument.type) << " | "
          << (argument.fields.empty() ? "no meaning here: " : "") << cell(argument.meaning)
          << " |\n";
  }
}

void printQueries(raw_ostream &out) {
  out << "\n## Queries\n\n"
         "`float name(string, variable)` asks for a value by name. Where there is one that the "
         "variable can take, sets it and gives 1; else leaves the variable and gives 0. The "
         "variable may be of any type, also an array. `textureinfo` has the file's name before "
         "that. Inside of `illuminance`, `lightsource(\"__nondiffuse\", x)` and "
         "`lightsource(\"__nonspecular\", x)` are always answered.\n\n"
         "| query | asks for | asked |\n|---|---|---|\n";
  for (const stc::QueryKind &kind : stc::allQueryKinds())
    out << "| `" << kind.name << "` | " << cell(kind.doc) << " | "
        << (kind.varying ? "at each point" : "once a batch") << " |\n";
}

void printMissing(raw_ostream &out) {
  MapVector<StringRef, std::vector<StringRef>> byNeed;
#define RSL_UNSUPPORTED(name, need) byNeed[need].push_back(#name);
#include "frontends/rsl/Builtins.def"
  out << "\n## Not there\n\nA call of one of these is an error that says so.\n\n"
         "| needs | built-ins |\n|---|---|\n";
  for (const auto &[need, names] : byNeed) {
    out << "| " << need << " | ";
    for (StringRef name : names)
      out << (name == names.front() ? "`" : ", `") << name << "`";
    out << " |\n";
  }
}

void printWarnings(raw_ostream &out) {
  out << "\n## Warnings\n\n`-Wno-NAME` switches one off, `-WNAME` on, `-Wall` all on, `-w` all "
         "off; "
         "`-Werror` makes errors of them.\n\n| option | default | about |\n|---|---|---|\n";
#define RSL_WARNING(name, option, onByDefault, about)                                              \
  out << "| `-W" option "` | " << (onByDefault ? "on" : "`-Wall`") << " | " about " |\n";
#include "frontends/rsl/Warnings.def"
}

} // namespace

int main() {
  raw_ostream &out = outs();
  out << "# The built-in functions of RSL\n\n"
         "Generated from `frontends/rsl/Builtins.def` by `rsl-reference`; do not edit. Points, "
         "vectors and "
         "normals may stand for each other, and a float for any of them. Where overloads differ "
         "only in "
         "their result, the context decides, and if it does not, the first.\n\n"
         "A function of floats alone also takes colors, points, vectors and normals, component by "
         "component: `sqrt(Cs)`, `pow(Cs, 2.2)`.\n\n"
         "`min` and `max` take two or more arguments.\n\n"
         "The directives of `printf` and `format` are `%f` `%e` `%g` for a float, `%d` for one "
         "shown as an integer, `%p` for a point, vector or normal, `%c` for a color, `%m` for a "
         "matrix, `%s` for a string, with flags, width and precision as in C; `%%` is a percent "
         "sign. The numbers of triples and matrices are separated by blanks. A value of another "
         "type than its directive's has its own type's form, with a warning if that is known at "
         "compile time (`-Wno-format` silences it).\n\n";
  printBuiltins(out);
  printSpecials(out);
  printNamed(out);
  printQueries(out);
  printMissing(out);
  printWarnings(out);
}
