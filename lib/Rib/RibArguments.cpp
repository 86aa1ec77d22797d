//===-- lib/Rib/RibArguments.cpp - what stands behind a request -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibArguments.h"

#include <cmath>

using namespace anysl::render;

namespace {

std::string kindName(const RibArgument &argument) {
  std::string base = argument.strings.empty() ? "number" : "string";
  return argument.isArray ? "an array of " + base + "s" : "a " + base;
}

} // namespace

const RibArgument &RibArguments::take(const char *what) {
  if (empty())
    throw UserError(request.where, request.name + ": " + what + " is missing");
  return request.arguments[next++];
}

bool RibArguments::nextIsText() const {
  return !empty() && !request.arguments[next].isArray && !request.arguments[next].strings.empty();
}

bool RibArguments::nextIsArray() const { return !empty() && request.arguments[next].isArray; }

uint32_t RibArguments::count(const char *what) {
  double value = number(what);
  if (!(value >= 0 && value <= 4e9 && value == std::floor(value)))
    throw UserError(request.where, request.name + ": " + what + ": " + std::to_string(value) +
                                       " is not a whole number of at least 0");
  return uint32_t(value);
}

std::vector<std::string> RibArguments::strings(const char *what) {
  const RibArgument &argument = take(what);
  if (!argument.isArray || !argument.numbers.empty())
    throw UserError(argument.where, request.name + ": " + what +
                                        ": expected an array of strings, found " +
                                        kindName(argument));
  return argument.strings;
}

double RibArguments::number(const char *what) { return numbers(1, what)[0]; }

std::vector<double> RibArguments::numbers(size_t count, const char *what) {
  const RibArgument &first = take(what);
  if (first.isArray) {
    if (first.numbers.size() != count)
      throw UserError(first.where, request.name + ": " + what + ": expected " +
                                       std::to_string(count) + " numbers, found " +
                                       std::to_string(first.numbers.size()));
    return first.numbers;
  }
  std::vector<double> result;
  --next;
  while (result.size() < count) {
    const RibArgument &argument = take(what);
    if (argument.isArray || argument.numbers.empty())
      throw UserError(argument.where, request.name + ": " + what + ": expected a number, found " +
                                          kindName(argument));
    result.push_back(argument.numbers[0]);
  }
  return result;
}

Vec3d RibArguments::triple(const char *what) {
  auto n = numbers(3, what);
  return {n[0], n[1], n[2]};
}

Matrix4 RibArguments::matrix() {
  auto n = numbers(16, "a matrix");
  Matrix4 result;
  for (int i = 0; i < 16; ++i)
    result.m[i / 4][i % 4] = n[i];
  return result;
}

std::vector<double> RibArguments::rest(const char *what) {
  std::vector<double> result;
  while (!empty()) {
    std::vector<double> some = array(what);
    result.insert(result.end(), some.begin(), some.end());
  }
  return result;
}

std::vector<double> RibArguments::array(const char *what) {
  const RibArgument &argument = take(what);
  if (!argument.strings.empty())
    throw UserError(argument.where,
                    request.name + ": " + what + ": expected numbers, found " + kindName(argument));
  return argument.numbers;
}

std::vector<uint32_t> RibArguments::indices(const char *what) {
  const RibArgument &argument = take(what);
  if (!argument.strings.empty() || !argument.isArray)
    throw UserError(argument.where, request.name + ": " + what +
                                        ": expected an array of numbers, found " +
                                        kindName(argument));
  std::vector<uint32_t> result;
  result.reserve(argument.numbers.size());
  for (double number : argument.numbers) {
    if (number < 0 || number > 4e9 || number != std::floor(number))
      throw UserError(argument.where, request.name + ": " + what + ": " + std::to_string(number) +
                                          " is not a whole number of at least 0");
    result.push_back(uint32_t(number));
  }
  return result;
}

std::string RibArguments::string(const char *what) {
  const RibArgument &argument = take(what);
  if (argument.strings.size() != 1)
    throw UserError(argument.where, request.name + ": " + what + ": expected a string, found " +
                                        kindName(argument));
  return argument.strings[0];
}

std::string RibArguments::handle(const char *what) {
  const RibArgument &argument = take(what);
  if (argument.strings.size() == 1)
    return argument.strings[0];
  if (argument.numbers.size() == 1)
    return std::to_string(static_cast<long long>(argument.numbers[0]));
  throw UserError(argument.where, request.name + ": " + what + ": expected one number or string");
}

ParameterList RibArguments::parameters() {
  ParameterList result;
  while (!empty()) {
    const RibArgument &token = take("a parameter");
    if (token.isArray || token.strings.empty())
      throw UserError(token.where,
                      request.name + ": expected a parameter's name, found " + kindName(token));
    if (empty())
      throw UserError(token.where,
                      request.name + ": parameter \"" + token.strings[0] + "\" has no value");
    const RibArgument &value = take("a value");
    Parameter parameter;
    parameter.where = token.where;
    if (token.strings[0].find_first_of(" \t") != std::string::npos) {
      parameter.declaration = parseDeclaration(token.strings[0], &parameter.name, token.where);
    } else {
      parameter.name = token.strings[0];
      if (auto known = declarations.find(parameter.name); known != declarations.end())
        parameter.declaration = known->second;
    }
    parameter.numbers = value.numbers;
    parameter.strings = value.strings;
    result.push_back(std::move(parameter));
  }
  return result;
}

Declaration anysl::render::parseDeclaration(std::string_view text, std::string *name,
                                            const Location &where) {
  static const std::map<std::string_view, StorageClass> storages = {
      {"constant", StorageClass::Constant},       {"uniform", StorageClass::Uniform},
      {"varying", StorageClass::Varying},         {"vertex", StorageClass::Vertex},
      {"facevarying", StorageClass::FaceVarying}, {"facevertex", StorageClass::FaceVarying}};
  static const std::map<std::string_view, ValueType> types = {
      {"float", ValueType::Float},   {"integer", ValueType::Float}, {"int", ValueType::Float},
      {"color", ValueType::Color},   {"point", ValueType::Point},   {"vector", ValueType::Vector},
      {"normal", ValueType::Normal}, {"hpoint", ValueType::HPoint}, {"matrix", ValueType::Matrix},
      {"string", ValueType::String}, {"shader", ValueType::String}};
  std::vector<std::string> words(1);
  for (char c : text) {
    bool separates = c == ' ' || c == '\t' || c == '[' || c == ']';
    if (separates && !words.back().empty())
      words.emplace_back();
    if (c == '[' || c == ']')
      words.back() = c, words.emplace_back();
    else if (!separates)
      words.back() += c;
  }
  if (words.back().empty())
    words.pop_back();

  auto fail = [&]() -> Declaration {
    throw UserError(where, "\"" + std::string(text) +
                               "\" is not a declaration such as \"uniform color" +
                               std::string(name ? " name\"" : "\""));
  };
  Declaration result;
  size_t word = 0;
  if (word < words.size())
    if (auto storage = storages.find(words[word]); storage != storages.end())
      result.storage = storage->second, ++word;
  auto type = word < words.size() ? types.find(words[word]) : types.end();
  if (type == types.end())
    return fail();
  result.type = type->second;
  ++word;
  if (word < words.size() && words[word] == "[") {
    if (word + 2 >= words.size() || words[word + 2] != "]")
      return fail();
    result.arrayLength = unsigned(std::strtoul(words[word + 1].c_str(), nullptr, 10));
    if (result.arrayLength == 0)
      return fail();
    word += 3;
  }
  if (words.size() - word != (name ? 1u : 0u))
    return fail();
  if (name)
    *name = words[word];
  return result;
}

unsigned anysl::render::componentCount(ValueType type) {
  switch (type) {
  case ValueType::Float:
  case ValueType::String:
    return 1;
  case ValueType::HPoint:
    return 4;
  case ValueType::Matrix:
    return 16;
  default:
    return 3;
  }
}

const Parameter *anysl::render::findParameter(const ParameterList &list, std::string_view name) {
  // The last one wins, as it does where requests are repeated.
  for (size_t i = list.size(); i-- > 0;)
    if (list[i].name == name)
      return &list[i];
  return nullptr;
}
