//===-- test/unit/Host/Fixture.h - handles that free themselves -----------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_UNIT_HOST_FIXTURE_H
#define ANYSL_TEST_UNIT_HOST_FIXTURE_H

#include <anysl/anysl.h>
#include <catch2/catch.hpp>
#include <memory>
#include <string>

template <auto function>
struct Call {
  template <class T>
  void operator()(T *object) const {
    function(object);
  }
};
using Library = std::unique_ptr<AnyslLibrary, Call<anysl_library_close>>;
using Instance = std::unique_ptr<AnyslInstance, Call<anysl_instance_free>>;
using Batch = std::unique_ptr<AnyslBatch, Call<anysl_batch_free>>;

inline std::string fixture(const std::string &name) { return FIXTURES + name + ".so"; }

inline Library open(const std::string &name, uint32_t flags = 0) {
  AnyslLibrary *library = nullptr;
  anysl_library_open(fixture(name).c_str(), flags, &library);
  INFO(anysl_last_error());
  REQUIRE(library);
  return Library(library);
}

inline Instance instantiate(AnyslLibrary *library, const AnyslServices *services = nullptr,
                            void *renderer = nullptr) {
  AnyslInstance *instance = nullptr;
  anysl_instance_create(library, "ramp", services, renderer, &instance);
  INFO(anysl_last_error());
  REQUIRE(instance);
  return Instance(instance);
}

inline Batch batchFor(const AnyslInstance *instance, uint32_t capacity, uint64_t more = 0) {
  AnyslBatch *batch = nullptr;
  anysl_batch_create(instance, capacity, more, &batch);
  INFO(anysl_last_error());
  REQUIRE(batch);
  return Batch(batch);
}

/// The message of the failure, with the folder of the fixtures taken out.
inline std::string message() {
  std::string text = anysl_last_error(), folder = FIXTURES;
  for (size_t at; (at = text.find(folder)) != std::string::npos;)
    text.erase(at, folder.size());
  return text;
}

#endif
