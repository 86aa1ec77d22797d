//===-- test/hard-cases/Subject.h - a shader whose every access is watched ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_SUBJECT_H
#define ANYSL_TEST_HARDCASES_SUBJECT_H

#include "test/hard-cases/Format.h"
#include <anysl/anysl.h>
#include <memory>
#include <string>

namespace hardcases {

/// Memory that ends at a page nobody may touch, and begins behind another.
class GuardedArray {
public:
  explicit GuardedArray(size_t bytes);
  ~GuardedArray();
  GuardedArray(const GuardedArray &) = delete;
  GuardedArray &operator=(const GuardedArray &) = delete;
  void *data() const { return begin; }

private:
  char *pages, *begin;
  size_t size;
};

/// A shader and two groups of points. Its first parameter is `active`; all others are inputs, if
/// they are not output parameters, and varying.
class Subject {
public:
  static constexpr uint32_t capacity = 32;

  /// Throws std::runtime_error where the shader cannot be run.
  Subject(AnyslLibrary *library, const std::string &shader);
  ~Subject();

  Format format() const;
  /// Whether the library's math tier takes care that no flags are raised.
  bool keepsFlags() const;
  size_t inputs() const { return inputCount; }
  size_t outputs() const { return outputCount; }
  /// Rounds to the library's format.
  void set(uint32_t point, bool active, const Numbers &values);
  void get(uint32_t point, Numbers &values) const;
  /// Sets every output to a value of no shader's.
  void clearOutputs();

  /// Shades points [first, last). Gives what went wrong: a signal, or a changed floating-point
  /// environment; else "". With `traps`, an invalid operation or a division by zero is a signal.
  std::string shade(uint32_t width, uint32_t first, uint32_t last, bool traps);

private:
  struct Place {
    uint32_t param, component, components;
  };
  void store(const Place &place, uint32_t point, double value);
  double load(const Place &place, uint32_t point) const;
  size_t indexOf(const Place &place, uint32_t point) const;

  const AnyslLibraryInfo *info;
  AnyslInstance *instance = nullptr;
  const AnyslShaderInfo *shader;
  size_t inputCount = 0, outputCount = 0;
  std::vector<Place> inputPlaces, outputPlaces;
  std::vector<std::unique_ptr<GuardedArray>> arrays;
  std::vector<void *> params, globals;
  std::vector<uint8_t> isGiven;
  AnyslShadeArgs args;
};

} // namespace hardcases

#endif
