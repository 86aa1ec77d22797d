//===-- lib/Link/MathChoice.cpp - which math tier computes what ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/MathChoice.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/JSON.h"
#include "llvm/Support/MemoryBuffer.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The only version of the file's format.
constexpr int64_t fileVersion = 1;

std::string join(ArrayRef<StringRef> names) {
  std::string result;
  for (StringRef name : names)
    result += (result.empty() ? "" : ", ") + name.str();
  return result;
}

/// Checks names as they are read. `where` says what they are part of.
class Names {
public:
  Names(DiagnosticEngine &diags, StringRef where, ArrayRef<std::string> knownTiers)
      : diags(diags), where(where), tiers(knownTiers.begin(), knownTiers.end()) {}

  bool isTier(StringRef name) const { return is(name, "math tier", tiers); }
  bool isFunction(StringRef name) const { return is(name, "elementary function", mathFunctions()); }

private:
  bool is(StringRef name, StringRef what, ArrayRef<StringRef> known) const {
    if (is_contained(known, name))
      return true;
    diags.error((where.empty() ? "" : where + ": ") + "there is no " + what + " '" + name + "'" +
                didYouMean(name, known) + " (there are: " + join(known) + ")");
    return false;
  }

  DiagnosticEngine &diags;
  std::string where;
  SmallVector<StringRef> tiers;
};

} // namespace

bool MathSite::fits(const FilePosition &position) const {
  StringRef path = position.file;
  return position.line == line && (!column || position.column == column) &&
         path.consume_back(file) && (path.empty() || path.ends_with("/"));
}

const std::string &MathChoice::tierOf(StringRef function) const {
  auto found = functions.find(function.str());
  return found == functions.end() ? tier : found->second;
}

const std::string &MathChoice::tierOf(StringRef function, const FilePosition &position) const {
  for (const MathSite &site : reverse(sites))
    if (site.function == function && site.fits(position))
      return site.tier;
  return tierOf(function);
}

std::vector<std::string> MathChoice::tiers() const {
  std::vector<std::string> result = {tier};
  auto add = [&](const std::string &name) {
    if (!is_contained(result, name))
      result.push_back(name);
  };
  for (const auto &[function, name] : functions)
    add(name);
  for (const MathSite &site : sites)
    add(site.tier);
  return result;
}

std::string MathChoice::text() const {
  std::string result = tier;
  for (const auto &[function, name] : functions)
    result += "," + function + "=" + name;
  for (const MathSite &site : sites) {
    result += "," + site.file + ":" + std::to_string(site.line);
    if (site.column)
      result += ":" + std::to_string(site.column);
    result += ":" + site.function + "=" + site.tier;
  }
  return result;
}

ArrayRef<StringRef> mathFunctions() {
  static const StringRef names[] = {
#define MATH_UNARY(name, ...) #name,
#define MATH_BINARY(name, ...) #name,
#include <anysl/MathFunctions.def>
  };
  return names;
}

bool readMathChoice(DiagnosticEngine &diags, StringRef text, StringRef where,
                    ArrayRef<std::string> knownTiers, MathChoice &choice) {
  Names names(diags, where, knownTiers);
  SmallVector<StringRef> items;
  text.split(items, ',');
  for (auto [i, item] : enumerate(items)) {
    auto [function, tier] = item.split('=');
    if (!item.contains('=')) {
      if (!names.isTier(item))
        return false;
      if (i > 0) {
        diags.error((where.empty() ? "" : where + ": ") + "the tier '" + item +
                    "' for all functions goes first: '" + item + ",sin=u35'");
        return false;
      }
      choice.tier = item.str();
      continue;
    }
    if (!names.isFunction(function) || !names.isTier(tier))
      return false;
    choice.functions[function.str()] = tier.str();
  }
  erase_if(choice.functions, [&](const auto &entry) { return entry.second == choice.tier; });
  return true;
}

bool readMathChoiceFile(DiagnosticEngine &diags, StringRef path, ArrayRef<std::string> knownTiers,
                        MathChoice &choice) {
  auto fail = [&](const Twine &message) {
    diags.error(FilePosition{path.str()}, message);
    return false;
  };
  auto buffer = MemoryBuffer::getFile(path, /*IsText=*/true);
  if (!buffer)
    return fail("cannot read the file: " + buffer.getError().message());
  auto value = json::parse((*buffer)->getBuffer());
  if (!value)
    return fail(toString(value.takeError()));
  const json::Object *file = value->getAsObject();
  auto version = file ? file->getInteger("version") : std::nullopt;
  if (!version)
    return fail("this is no file of math choices: it has no \"version\"");
  if (*version != fileVersion)
    return fail("this file of math choices has version " + Twine(*version) +
                ", and this program reads version " + Twine(fileVersion));
  if (auto math = file->getString("math");
      math && !readMathChoice(diags, *math, path, knownTiers, choice))
    return false;
  Names names(diags, path, knownTiers);
  const json::Array *sites = file->getArray("sites");
  for (const json::Value &entry : sites ? *sites : json::Array()) {
    const json::Object *object = entry.getAsObject();
    auto text = [&](StringRef key) { return object ? object->getString(key) : std::nullopt; };
    auto number = [&](StringRef key) { return object ? object->getInteger(key) : std::nullopt; };
    auto name = text("file"), function = text("function"), tier = text("tier");
    auto line = number("line"), column = number("column");
    if (!name || name->empty() || !function || !tier || !line || *line < 1)
      return fail("each of \"sites\" has a \"file\", a \"line\" from 1, a \"function\" and a "
                  "\"tier\"");
    if (!names.isFunction(*function) || !names.isTier(*tier))
      return false;
    choice.sites.push_back(
        {name->str(), unsigned(*line), unsigned(column.value_or(0)), function->str(), tier->str()});
  }
  return true;
}

} // namespace anysl::link
