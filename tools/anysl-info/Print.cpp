//===-- tools/anysl-info/Print.cpp - a description as text and as JSON ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-info/Description.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace llvm;

namespace anysl::info {
namespace {

/// As few digits as tell the number from its neighbours, up to a double's.
std::string number(double value) {
  char text[40];
  for (int digits : {6, 9, 17}) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
      break;
  }
  return text;
}

std::string quoted(StringRef text) {
  std::string result = "\"";
  raw_string_ostream out(result);
  printEscapedString(text, out);
  return result + "\"";
}

std::string element(const Default &value, unsigned components, unsigned index) {
  if (const auto *texts = std::get_if<std::vector<std::string>>(&value))
    return quoted((*texts)[index]);
  const auto &numbers = std::get<std::vector<double>>(value);
  if (components == 1)
    return number(numbers[index]);
  std::string text = "(";
  for (unsigned c = 0; c < components; ++c)
    text += (c ? ", " : "") + number(numbers[index * components + c]);
  return text + ")";
}

std::string defaultText(const Param &param) {
  if (!param.arrayLength)
    return element(*param.defaultValue, param.components, 0);
  std::string text = "{";
  for (unsigned e = 0; e < param.arrayLength; ++e)
    text += (e ? ", " : "") + element(*param.defaultValue, param.components, e);
  return text + "}";
}

/// The parameter as it would be declared.
std::string declaration(const Param &param) {
  std::string text = param.output ? "output " : "";
  text += param.varying ? "varying " : "uniform ";
  text += param.type + " " + param.name;
  if (param.arrayLength)
    text += "[" + std::to_string(param.arrayLength) + "]";
  if (param.defaultValue)
    text += " = " + defaultText(param);
  return text + (param.fixed ? "  (fixed by anysl-link)" : "");
}

std::string list(const std::vector<std::string> &names) {
  return names.empty() ? "none" : join(names, " ");
}

std::string list(const std::vector<unsigned> &numbers) {
  std::string text;
  for (unsigned n : numbers)
    text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

void line(raw_ostream &out, StringRef name, const Twine &value) {
  out << "  " << left_justify(name, 12) << value << '\n';
}

void printShader(const Shader &shader, raw_ostream &out) {
  out << '\n' << shader.kind << ' ' << shader.name << '\n';
  if (!shader.widths.empty())
    line(out, "widths", list(shader.widths));
  line(out, "reads", list(shader.globalsRead));
  line(out, "writes", list(shader.globalsWritten));
  line(out, "services", list(shader.services));
  line(out, "effects", list(shader.effects));
  StringRef title = "parameters";
  if (shader.params.empty())
    line(out, title, "none");
  for (const Param &param : shader.params) {
    line(out, title, declaration(param));
    title = "";
  }
}

json::Value jsonNumber(double value) {
  // JSON has no word for these.
  if (!std::isfinite(value))
    return std::isnan(value) ? "NaN" : value < 0 ? "-Infinity" : "Infinity";
  return value;
}

void jsonNames(json::OStream &json, StringRef key, const std::vector<std::string> &names) {
  json.attributeArray(key, [&] {
    for (const std::string &name : names)
      json.value(name);
  });
}

void jsonParam(json::OStream &json, const Param &param) {
  json.attribute("name", param.name);
  json.attribute("type", param.type);
  json.attribute("storage", param.varying ? "varying" : "uniform");
  json.attribute("output", param.output);
  json.attribute("fixed", param.fixed);
  json.attribute("array_length", param.arrayLength);
  if (!param.defaultValue)
    return;
  json.attributeArray("default", [&] {
    if (const auto *texts = std::get_if<std::vector<std::string>>(&*param.defaultValue))
      for (const std::string &text : *texts)
        json.value(text);
    else
      for (double value : std::get<std::vector<double>>(*param.defaultValue))
        json.value(jsonNumber(value));
  });
}

void jsonShader(json::OStream &json, const Shader &shader) {
  json.attribute("name", shader.name);
  json.attribute("kind", shader.kind);
  if (!shader.widths.empty())
    json.attributeArray("widths", [&] {
      for (unsigned width : shader.widths)
        json.value(width);
    });
  jsonNames(json, "globals_read", shader.globalsRead);
  jsonNames(json, "globals_written", shader.globalsWritten);
  jsonNames(json, "services", shader.services);
  jsonNames(json, "effects", shader.effects);
  json.attributeArray("parameters", [&] {
    for (const Param &param : shader.params)
      json.object([&] { jsonParam(json, param); });
  });
}

} // namespace

void printText(const Description &description, raw_ostream &out) {
  out << description.path << ": "
      << (description.target ? "shader library" : "subroutine-threaded code") << ", made by "
      << description.producer << '\n';
  if (const auto &target = description.target) {
    line(out, "runtime", target->runtime + ", layout " + target->layout);
    line(out, "real", target->real);
    line(out, "math", target->math);
    line(out, "target", target->cpu);
    line(out, "features", list(target->cpuFeatures));
    line(out, "runs here", target->refusal.empty() ? "yes" : "no: " + target->refusal);
  }
  for (const Shader &shader : description.shaders)
    printShader(shader, out);
}

void printJson(const Description &description, raw_ostream &out) {
  json::OStream json(out, 2);
  json.object([&] {
    json.attribute("file", description.path);
    json.attribute("form", description.target ? "library" : "stc");
    json.attribute("producer", description.producer);
    if (const auto &target = description.target) {
      json.attribute("runtime", target->runtime);
      json.attribute("layout", target->layout);
      json.attribute("real", target->real);
      json.attribute("math", target->math);
      json.attribute("target_cpu", target->cpu);
      jsonNames(json, "cpu_features", target->cpuFeatures);
      json.attribute("runs_here", target->refusal.empty());
    }
    if (const auto &asking = description.asking) {
      if (asking->names)
        jsonNames(json, "asked", *asking->names);
      else
        json.attribute("asked", nullptr);
      json.attribute("traces_for_others", asking->tracesForOthers);
    }
    json.attributeArray("shaders", [&] {
      for (const Shader &shader : description.shaders)
        json.object([&] { jsonShader(json, shader); });
    });
  });
  out << '\n';
}

} // namespace anysl::info
