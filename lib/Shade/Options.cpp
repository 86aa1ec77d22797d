//===-- lib/Shade/Options.cpp - what to shade, and in which world
//----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Options.h"
#include <algorithm>
#include <charconv>
#include <cmath>

namespace anysl::shade {
namespace {

[[noreturn]] void fail(const std::string &message) { throw UserError(message); }

void parseGrid(GridOptions &options, const std::string &text) {
  std::vector<std::string> sides = split(text, 'x');
  if (sides.size() != 2)
    fail("--grid wants WIDTHxHEIGHT, not '" + text + "'");
  options.gridWidth = parseCount(sides[0], "--grid");
  options.gridHeight = parseCount(sides[1], "--grid");
  if (uint64_t(options.gridWidth) * options.gridHeight > (uint64_t(1) << 28))
    fail("--grid " + text + " has more points than fit into memory");
}

Ramp parseRamp(const std::string &text) {
  auto [name, value] = parseAssignment(text, "--ramp");
  std::vector<std::string> parts = split(value, ':');
  if (parts.size() != 3)
    fail("--ramp wants NAME=FROM:TO:AXIS, not '" + text + "'");
  auto names = [&](std::initializer_list<std::string> axes) {
    return std::find(axes.begin(), axes.end(), parts[2]) != axes.end();
  };
  bool across = names({"x", "i", "u", "s"}), down = names({"y", "j", "v", "t"});
  if (!across && !down)
    fail("the axis of --ramp is x (or i, u, s) or y (or j, v, t), not '" + parts[2] + "'");
  Ramp ramp = {name, parseNumbers(parts[0], "--ramp"), parseNumbers(parts[1], "--ramp"), down};
  if (ramp.from.size() != ramp.to.size())
    fail("the ends of --ramp " + text + " have different numbers of components");
  return ramp;
}

void parseSurroundings(Environment &environment, const std::string &text) {
  environment.surroundingsGiven = true;
  if (text == "sky")
    environment.surroundings = Surroundings::Sky;
  else if (text == "direction")
    environment.surroundings = Surroundings::Direction;
  else if (text == "black")
    environment.surroundings = Surroundings::Black;
  else
    fail("--environment is sky, direction or black, not '" + text + "'");
}

void parseSpace(Environment &environment, const std::string &text) {
  auto [name, value] = parseAssignment(text, "--space");
  environment.toCurrent[name] = parseMatrix(value, "--space " + name);
  environment.givenSpaces.insert(name);
}

void parseCoshader(GridOptions &options, const std::string &description) {
  auto [handle, rest] = parseAssignment(description, "--coshader");
  std::vector<std::string> parts = split(rest, ':');
  CoshaderText coshader = {handle, parts[0], {}};
  for (size_t i = 1; i < parts.size(); ++i) {
    auto [name, value] = parseAssignment(parts[i], "--coshader");
    coshader.params.push_back({name, value});
  }
  options.coshaders.push_back(std::move(coshader));
}

/// What a query of a kind answers to a name.
void addAnswer(Environment &environment, uint32_t kind, const std::string &text,
               const std::string &option) {
  auto [name, value] = parseAssignment(text, option);
  KnownValue known;
  for (const std::string &part : split(value, ',')) {
    double number = 0;
    const char *end = part.data() + part.size();
    auto [stop, error] = std::from_chars(part.data(), end, number);
    if (error == std::errc() && stop == end)
      known.numbers.push_back(number);
    known.texts.push_back(part);
  }
  if (known.numbers.size() != known.texts.size())
    known.numbers.clear();
  environment.answers[{kind, name}] = std::move(known);
}

void parseQuery(Environment &environment, const std::string &text) {
  static constexpr std::pair<const char *, uint32_t> kinds[] = {
#define ANYSL_QUERY(id, name, storage, doc) {#name, id},
#include <anysl/QueryKinds.def>
  };
  size_t colon = text.find(':');
  for (auto [name, kind] : kinds)
    if (colon != std::string::npos && text.substr(0, colon) == name)
      return addAnswer(environment, kind, text.substr(colon + 1), "--query");
  fail("--query wants KIND:NAME=VALUE, not '" + text + "'");
}

constexpr GridOption table[] = {
    {"--grid", parseGrid},
    {"--set",
     [](GridOptions &o, const std::string &v) {
       auto [name, value] = parseAssignment(v, "--set");
       o.constants.push_back({name, parseNumbers(value, "--set")});
     }},
    {"--ramp", [](GridOptions &o, const std::string &v) { o.ramps.push_back(parseRamp(v)); }},
    {"--param",
     [](GridOptions &o, const std::string &v) {
       auto [name, value] = parseAssignment(v, "--param");
       o.params.push_back({name, value});
     }},
    {"--inputs",
     [](GridOptions &o, const std::string &v) {
       for (RecordedShader &shader : readRecording(v))
         o.recorded.push_back(std::make_shared<RecordedShader>(std::move(shader)));
     }},
    {"--environment",
     [](GridOptions &o, const std::string &v) { parseSurroundings(o.environment, v); }},
    {"--light", [](GridOptions &o, const std::string &v) { o.lights.push_back(v); }},
    {"--texture-path",
     [](GridOptions &o, const std::string &v) {
       for (const std::string &folder : split(v, ':'))
         o.environment.pictures->searchPath.push_back(folder);
     }},
    {"--coshader", parseCoshader},
    {"--attribute",
     [](GridOptions &o, const std::string &v) {
       addAnswer(o.environment, ANYSL_QUERY_attribute, v, "--attribute");
     }},
    {"--option",
     [](GridOptions &o, const std::string &v) {
       addAnswer(o.environment, ANYSL_QUERY_option, v, "--option");
     }},
    {"--query", [](GridOptions &o, const std::string &v) { parseQuery(o.environment, v); }},
    {"--space", [](GridOptions &o, const std::string &v) { parseSpace(o.environment, v); }},
};

} // namespace

unsigned parseCount(const std::string &text, const std::string &option) {
  unsigned value = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !value)
    fail(option + " wants a positive whole number, not '" + text + "'");
  return value;
}

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  for (size_t begin = 0;;) {
    size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos)
      return parts;
    begin = end + 1;
  }
}

/// NAME=VALUE, both sides of it.
std::pair<std::string, std::string> parseAssignment(const std::string &text,
                                                    const std::string &option) {
  size_t at = text.find('=');
  if (at == 0 || at == std::string::npos)
    throw UserError(option + " wants NAME=VALUE, not '" + text + "'");
  return {text.substr(0, at), text.substr(at + 1)};
}

std::vector<double> parseNumbers(const std::string &text, const std::string &option) {
  std::vector<double> numbers;
  for (const std::string &part : split(text, ',')) {
    double value = 0;
    const char *begin = part.data() + (part[0] == '+'), *end = part.data() + part.size();
    auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end)
      fail(option + ": '" + part + "' is not a number");
    numbers.push_back(value);
  }
  return numbers;
}

Matrix parseMatrix(const std::string &text, const std::string &option) {
  std::vector<double> numbers = parseNumbers(text, option);
  if (numbers.size() != 16)
    throw UserError(option + " wants 16 numbers, not " + std::to_string(numbers.size()));
  Matrix matrix;
  std::copy(numbers.begin(), numbers.end(), matrix.begin());
  for (double element : inverse(matrix))
    if (!std::isfinite(element))
      throw UserError("the matrix of " + option + " has no inverse");
  return matrix;
}

const char *const gridHelp = R"(Point (i, j) of a W x H grid has
  s = u = i/(W-1), t = v = j/(H-1) (0 where the side is 1), P = (u, v, 0),
  dPdu = (1,0,0), dPdv = (0,1,0) (a ramp of P has its own), N = Ng = (0,0,1), I = (0,0,-1), E = (0,0,1),
  Cs = Os = 1, Ci = 0, Oi = Os, du and dv the grid step (1 where the side is 1),
  time = 0, ncomps = 3, alpha = 1, Ps = P, Ns = N, everything else 0.
)";

const char *const pointsHelp =
    R"(  --set NAME=v[,v...]      a global (or varying parameter) has this value everywhere
  --ramp NAME=a:b:AXIS     it goes from a to b along the axis x (also i, u, s) or y (j, v, t);
                           a and b are v[,v...]
  --param NAME=v[,v...]    a parameter's value: numbers, or text; also SHADER.NAME=...
  --inputs FILE            in place of the grid, the points of this shader that anysl-render
                           --record wrote, with their parameters, lights and spaces; what rays
                           meet is not recorded: nothing, unless --environment says otherwise
)";

const char *const worldHelp = R"(The world around it:
  --environment sky|direction|black
      what trace() sees; d is the direction, of unit length. sky (default):
      (0.9,0.95,1)*(1-d.z) + (0.25,0.5,0.9)*d.z above, (0.3,0.25,0.2) below;
      direction: (1+d)/2. The ground, plane z = -1, is what stops rays (not in black).
  --light KIND[:KEY=v[,v...]]...   add a light; KIND is
      ambient   color, intensity
      distant   color, intensity, direction (in which the light travels; 0,0,-1)
      point     color, intensity, from (0,0,1)
      spot      color, intensity, from (0,0,1), direction or to, cone (30), delta (5), beam (2);
                cone and delta in degrees
      and the flags shadow, nondiffuse, nonspecular; or, with the parameters of the standard's
      shaders of these names, ambientlight, distantlight, pointlight, spotlight; category=NAME;
      handle=NAME, what getlights() calls it ("light0", "light1" ... in order)
  --light FILE.so[:SHADER][:PARAM=v[,v...]]...   add a light that a light shader computes; also the
      flag shadow, handle=NAME, and space=m,... (16 numbers), the matrix from its own space to the current one
  --texture-path DIR[:DIR...]
                           where textures are looked for, after the current folder
  --coshader HANDLE=FILE.so[:NAME=v[,v...]]...
      getshader(HANDLE) is this library's first shader or class, with these parameters;
      its parameter __category is what getshaders() chooses by
  --attribute NAME=v[,v...]   what attribute("NAME", x) gives: numbers or text, for x of any
  --option NAME=v[,v...]      type with as many components (or for a single number, of any
                           type of numbers); option("NAME", x) likewise
  --query KIND:NAME=v[,v...]  the same for any query: surface, displacement, atmosphere,
                           incident, opposite, rendererinfo, rayinfo; and
                           textureinfo:FILE:NAME. The shaders' own name is "shadername"
  --space NAME=m,...       16 numbers, the matrix (row by row, for row vectors) from a
                           named coordinate system to the current one
)";

std::span<const GridOption> gridOptions() { return table; }

} // namespace anysl::shade
