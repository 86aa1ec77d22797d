//===-- tools/anysl-cost/Stability.cpp - what was found unstable, for people and programs -----===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-cost/Stability.h"
#include "lib/Plot/HeatMap.h"
#include "lib/Plot/Plot.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/Path.h"
#include <cmath>

using namespace llvm;

namespace anysl::cost {
namespace {

/// Of recorded points so many columns and rows are drawn.
constexpr unsigned mapSide = 64, largestSide = 128;

std::string count(size_t number, StringRef thing) {
  return std::to_string(number) + " " + thing.str() + (number == 1 ? "" : "s");
}
std::string oneDecimal(double value) { return formatv("{0:f1}", value).str(); }
std::string share(size_t part, size_t all) {
  return formatv("{0} ({1:f1} %)", part, all ? 100.0 * double(part) / double(all) : 0).str();
}

template <typename Numbers>
std::string list(const Numbers &numbers) {
  std::string text;
  raw_string_ostream out(text);
  ListSeparator separator(",");
  for (double number : numbers)
    out << StringRef(separator) << format("%.9g", std::isnan(number) ? std::fabs(number) : number);
  return out.str();
}
std::string value(ArrayRef<double> numbers) {
  return numbers.size() == 1 ? list(numbers) : "(" + list(numbers) + ")";
}

/// "sub_float(1, 0.999999)".
std::string operation(const UnstablePlace &place) {
  std::string text = place.op + "(";
  for (const auto &operand : place.worst.operands)
    text += (&operand == &place.worst.operands.front() ? "" : ", ") + value(operand);
  return text + ")";
}

/// "Ci loses 5.2 of 7.2 digits".
std::string effect(const StabilityReport &report, const UnstablePlace &place) {
  const Incident &worst = place.worst;
  if (worst.result.empty())
    return "no result loses more than " + oneDecimal(report.limit) + " digits by it";
  if (std::isinf(worst.lost))
    return worst.result + " is " + value(worst.resultValue) + ", exactly " +
           value(worst.exactResult);
  return worst.result + " loses " + oneDecimal(worst.lost) + " of " + oneDecimal(report.digits) +
         " digits";
}

std::string describe(const StabilityReport &report, const UnstablePlace &place) {
  const Incident &worst = place.worst;
  std::string text = operation(place);
  switch (place.cause) {
  case Cause::LostDigits:
    return text + " is " + value(worst.value) + ", exactly " + value(worst.exactValue) + ": " +
           effect(report, place) + ", " + oneDecimal(worst.added) + " of them here";
  case Cause::Branch:
    return text + " is " + value(worst.value) + ", exactly " + value(worst.exactValue) + ": " +
           effect(report, place);
  case Cause::NotFinite:
    return text + " is " + value(worst.value) +
           (worst.isExactFinite ? ", exactly " + value(worst.exactValue)
                                : ", in exact arithmetic as well") +
           ": " + effect(report, place);
  }
  return text;
}

StringRef nameOf(Cause cause) {
  switch (cause) {
  case Cause::LostDigits:
    return "lost digits";
  case Cause::Branch:
    return "branch";
  case Cause::NotFinite:
    return "not finite";
  }
  return "";
}

/// As anysl-shade takes it.
std::string inputsOf(const Incident &incident) {
  std::string text;
  for (const auto &[name, numbers] : incident.inputs)
    text += (text.empty() ? "--set " : " --set ") + name + "=" + list(numbers);
  return text;
}

std::string whereOf(const UnstablePlace &place) {
  return place.points
             ? "at " + count(place.points, "point") +
                   (place.foundPoints
                        ? " and " + std::to_string(place.foundPoints) + " more about the worst"
                        : "")
             : "at " + count(place.foundPoints, "point") + " about the worst only";
}

/// What one should know first.
std::vector<std::string> summary(const StabilityReport &report) {
  std::vector<std::string> lines;
  lines.push_back(share(report.unstable, report.points) + " of " + count(report.points, "point") +
                  " lose more than " + oneDecimal(report.limit) + " of the " +
                  oneDecimal(report.digits) + " digits of " + report.real + ".");
  if (report.proven)
    lines.push_back("Interval bounds prove of " + share(*report.proven, report.points) +
                    " that they lose no more, whatever is rounded.");
  if (report.foundPoints)
    lines.push_back("Another " + count(report.foundPoints, "point") +
                    " about the worst were tried.");
  if (report.unstablePlaces.empty())
    lines.push_back("No operator spoils a result.");
  if (!report.isComplete)
    lines.push_back("Loops with more than " + std::to_string(Tracer::mostSteps) +
                    " operators at one point were not followed to their end.");
  return lines;
}

plot::HeatMap mapOf(const StabilityReport &report) {
  plot::HeatMap map;
  map.title = report.shader + ": digits that rounding costs";
  map.largest = report.digits;
  map.unit = "digits";
  if (any_of(report.lost, [](double lost) { return std::isinf(lost); }))
    map.aboveName = "not a number, or infinite";
  map.width = report.width;
  map.height = report.height;
  map.values = report.lost;
  map.xLabel = "column of the grid";
  map.yLabel = "row";
  if (!report.places.empty()) {
    map.width = map.height = mapSide;
    map.values.assign(size_t(mapSide) * mapSide, std::nan(""));
    map.xLabel = "u, or s";
    map.yLabel = "v, t";
    auto cell = [](float x) {
      return size_t(std::clamp(int(x * float(mapSide)), 0, int(mapSide) - 1));
    };
    for (auto [place, lost] : zip(report.places, report.lost)) {
      double &known = map.values[cell(place[1]) * mapSide + cell(place[0])];
      if (!(known >= lost))
        known = lost;
    }
  } else if (!map.width) {
    map.width = unsigned(std::ceil(std::sqrt(double(report.points))));
    map.height = (unsigned(report.points) + map.width - 1) / std::max(map.width, 1u);
    map.values.resize(size_t(map.width) * map.height, std::nan(""));
    map.xLabel = "points in the order of their file";
    map.yLabel = "";
  }
  return reduced(map, largestSide);
}

std::string code(const std::string &text) { return "<code>" + plot::escaped(text) + "</code>"; }

std::string section(const StabilityReport &report) {
  std::string body = "<section>\n" + svg(mapOf(report)) + "<div class=\"glance\"><ul>\n";
  for (const std::string &line : summary(report))
    body += "<li>" + plot::escaped(line) + "</li>\n";
  body += "</ul></div>\n<p class=\"soft\">" + plot::escaped(report.kind) + " shader <b>" +
          plot::escaped(report.shader) + "</b> of " + plot::escaped(report.file) + ", " +
          plot::escaped(report.real) + " against " + plot::escaped(report.oracle) + ".</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const UnstablePlace &place : report.unstablePlaces)
    rows.push_back(
        {code(sys::path::filename(place.position.file).str() + ":" +
              std::to_string(place.position.line) + ":" + std::to_string(place.position.column)),
         nameOf(place.cause).str(), code(operation(place)), code(value(place.worst.value)),
         code(value(place.worst.exactValue)), plot::escaped(effect(report, place)),
         std::to_string(place.points), std::to_string(place.foundPoints),
         code(inputsOf(place.worst))});
  if (!rows.empty())
    body += "<h3>Operators that spoil results, the worst first</h3>\n" +
            plot::table({"line", "what", "operator", "gives", "exactly", "effect", "points",
                         "more about the worst", "worst where"},
                        rows);
  rows.clear();
  for (const UndecidedPlace &place : report.undecided)
    rows.push_back(
        {code(sys::path::filename(place.position.file).str() + ":" +
              std::to_string(place.position.line) + ":" + std::to_string(place.position.column)),
         code(place.op), std::to_string(place.points)});
  if (!rows.empty())
    body += "<h3>Conditions that interval bounds do not decide</h3>\n" +
            plot::table({"line", "operator", "points"}, rows);
  return body + "</section>\n";
}

json::Value number(double value) {
  return std::isfinite(value) ? json::Value(value) : json::Value(nullptr);
}
template <typename Numbers>
json::Array numbers(const Numbers &values) {
  json::Array result;
  for (double value : values)
    result.push_back(number(value));
  return result;
}

json::Object positionOf(const FilePosition &position, const std::string &op) {
  return json::Object{{"file", position.file},
                      {"line", position.line},
                      {"column", position.column},
                      {"operator", op}};
}

json::Value toJson(const UnstablePlace &place) {
  const Incident &worst = place.worst;
  json::Object result = positionOf(place.position, place.op), inputs;
  json::Array operands;
  for (const auto &operand : worst.operands)
    operands.push_back(numbers(operand));
  for (const auto &[name, values] : worst.inputs)
    inputs[name] = numbers(values);
  result["cause"] = nameOf(place.cause);
  result["points"] = int64_t(place.points);
  result["foundPoints"] = int64_t(place.foundPoints);
  result["result"] = worst.result;
  result["lostDigits"] = number(worst.lost);
  result["lostHere"] = number(worst.added);
  result["operands"] = std::move(operands);
  result["value"] = numbers(worst.value);
  result["exact"] = numbers(worst.exactValue);
  result["inputs"] = std::move(inputs);
  return result;
}

} // namespace

void printStability(const StabilityReport &report, raw_ostream &out) {
  out << report.shader << ", " << report.real << " against " << report.oracle << '\n';
  for (const std::string &line : summary(report))
    out << "  - " << line << '\n';
  DiagnosticEngine diags("anysl-cost", out);
  for (const UnstablePlace &place : report.unstablePlaces) {
    Diagnostic found;
    found.severity = Severity::Warning;
    found.position = place.position;
    found.message = describe(report, place) + ", " + whereOf(place);
    Diagnostic &note = found.notes.emplace_back();
    note.severity = Severity::Note;
    note.position = place.position;
    note.showsLine = false;
    note.message = "worst with " + inputsOf(place.worst);
    if (place.worst.inputs.empty())
      found.notes.clear();
    diags.report(std::move(found));
  }
  if (size_t undecided = report.undecided.size()) {
    out << "  " << count(undecided, "condition") << " that interval bounds do not decide:";
    ListSeparator separator(",");
    for (const UndecidedPlace &place : report.undecided)
      out << StringRef(separator) << ' ' << sys::path::filename(place.position.file) << ':'
          << place.position.line << ':' << place.position.column << ' ' << place.op << " at "
          << count(place.points, "point");
    out << '\n';
  }
}

std::string stabilityToHtml(ArrayRef<StabilityReport> reports) {
  std::string names, body;
  for (const StabilityReport &report : reports) {
    names += (names.empty() ? "" : ", ") + report.shader;
    body += section(report);
  }
  body += "<p class=\"soft\">anysl-cost " ANYSL_VERSION "</p>\n";
  return plot::page("What rounding costs: " + names, body);
}

json::Value stabilityToJson(ArrayRef<StabilityReport> reports) {
  json::Array shaders;
  for (const StabilityReport &report : reports) {
    json::Array places, undecided;
    for (const UnstablePlace &place : report.unstablePlaces)
      places.push_back(toJson(place));
    for (const UndecidedPlace &place : report.undecided) {
      json::Object entry = positionOf(place.position, place.op);
      entry["points"] = int64_t(place.points);
      undecided.push_back(std::move(entry));
    }
    shaders.push_back(json::Object{
        {"shader", report.shader},
        {"kind", report.kind},
        {"file", report.file},
        {"real", report.real},
        {"oracle", report.oracle},
        {"limit", report.limit},
        {"digits", report.digits},
        {"points", int64_t(report.points)},
        {"foundPoints", int64_t(report.foundPoints)},
        {"unstable", int64_t(report.unstable)},
        {"proven", report.proven ? json::Value(int64_t(*report.proven)) : json::Value(nullptr)},
        {"complete", report.isComplete},
        {"lost", numbers(report.lost)},
        {"places", std::move(places)},
        {"undecided", std::move(undecided)}});
  }
  return json::Object{{"shaders", std::move(shaders)}};
}

} // namespace anysl::cost
