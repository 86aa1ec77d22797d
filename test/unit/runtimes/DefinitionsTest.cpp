//===-- test/unit/runtimes/DefinitionsTest.cpp - each operator has one definition -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Reads the bitcode that the linker reads: for each real and each interface runtime, the table's
// operators are defined by exactly one of the shading library, the real and the runtime; those that
// a renderer may decline by one at most.
//
//===------------------------------------------------------------------------------------------===//

#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/SourceMgr.h"
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

using Names = std::set<std::string>;

namespace {

const std::string folder = ANYSL_BITCODE_FOLDER;

/// The functions and variables named anysl_... that a module defines.
Names definitions(const std::string &path) {
  llvm::LLVMContext context;
  llvm::SMDiagnostic error;
  std::unique_ptr<llvm::Module> module = llvm::parseIRFile(path, error, context);
  INFO(path);
  REQUIRE(module);
  Names names;
  for (const llvm::GlobalObject &object : module->global_objects())
    if (!object.isDeclaration() && object.getName().starts_with("anysl_"))
      names.insert(object.getName().str());
  return names;
}

/// The names before ".bc" of the modules of a subfolder.
std::vector<std::string> modules(const std::string &subfolder) {
  std::vector<std::string> result;
  std::error_code error;
  for (llvm::sys::fs::directory_iterator i(folder + "/" + subfolder, error), end;
       i != end && !error; i.increment(error))
    if (llvm::sys::path::extension(i->path()) == ".bc")
      result.push_back(llvm::sys::path::stem(i->path()).str());
  return result;
}

} // namespace

TEST_CASE("every operator has one definition in each combination of runtime and real") {
  const Names mayBeDeclined = {
#define STC_NEUTRAL(name, value, meaning) #name,
#include "lib/STC/Neutral.def"
  };
  const Names library = definitions(folder + "/shadelib.stc.bc");
  std::vector<std::string> runtimes = modules("runtime");
  REQUIRE(runtimes.size() >= 3);
  for (const std::string &runtime : runtimes) {
    std::string real = runtime.substr(runtime.find('.') + 1);
    const Names ofReal = definitions(folder + "/real/" + real + ".bc");
    const Names ofRuntime = definitions(folder + "/runtime/" + runtime + ".bc");
#define Structural 0
#define Pure 1
#define Reads 1
#define Writes 1
#define Stateful 1
#define STC_OP(id, name, result, parameters, purity, ...)                                          \
  {                                                                                                \
    INFO(runtime << ": " #name);                                                                   \
    size_t found = library.count("anysl_" #name) + ofReal.count("anysl_" #name) +                  \
                   ofRuntime.count("anysl_" #name);                                                \
    CHECK((found == purity || (found == 0 && mayBeDeclined.count(#name))));                        \
  }
#include <anysl/StcOps.def>
#define STC_TYPE(id, name, components, meaning) CHECK(ofReal.count("anysl_type_" #name) == 1);
#include <anysl/Types.def>
    for (const char *hook :
         {"anysl_runtime_shade_point", "anysl_runtime_init", "anysl_runtime_layout"})
      CHECK(ofRuntime.count(hook) == 1);
  }
}
