//===-- test/unit/Link/RangeTest.cpp - entries shade what they are asked to ---------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Links Ci = Cs * Cs with the packet runtime, loads the library and calls its entries themselves.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Emit.h"
#include "lib/Emit/Target.h"
#include "lib/Link/Linker.h"
#include "lib/STC/Builder.h"
#include "lib/STC/Writer.h"
#include "llvm/Support/FileSystem.h"
#include <anysl/abi.h>
#include <array>
#include <catch2/catch.hpp>
#include <dlfcn.h>

using namespace anysl;

namespace {

std::unique_ptr<llvm::Module> squareShader(llvm::LLVMContext &context) {
  stc::Builder b(context, "square.sl", "test 1.0");
  stc::ShaderInfo info;
  info.name = "square";
  b.setLocation("square.sl", 1, 1);
  info.init = b.beginFunction("square.init");
  b.ir().CreateRetVoid();
  info.body = b.beginFunction("square");
  llvm::Value *color = b.alloc(stc::Type::colorTy, "Cs", stc::Storage::Varying);
  b.call(stc::Op::load_global_color, {color, b.context(), b.id(ANYSL_Cs)});
  b.call(stc::Op::mul_color, {color, color, color});
  b.call(stc::Op::store_global_color, {b.context(), b.id(ANYSL_Ci), color});
  b.ir().CreateRetVoid();
  info.globals = {{ANYSL_Cs, true, false}, {ANYSL_Ci, false, true}};
  b.addShader(info);
  return b.finish();
}

/// The library, linked and loaded once.
const AnyslLibraryInfo *library() {
  static const AnyslLibraryInfo *loaded = [] {
    llvm::SmallString<128> stcPath, soPath;
    REQUIRE_FALSE(llvm::sys::fs::createTemporaryFile("square", "stc.bc", stcPath));
    REQUIRE_FALSE(llvm::sys::fs::createTemporaryFile("square", "so", soPath));
    {
      llvm::LLVMContext context;
      std::error_code code;
      llvm::raw_fd_ostream out(stcPath, code);
      stc::writeBitcode(*squareShader(context), out);
    }
    DiagnosticEngine diags("link-tests");
    llvm::LLVMContext context;
    auto target = makeTarget(diags, "native", "");
    link::LinkOptions options;
    options.resourceDir = ANYSL_RESOURCE_DIR;
    options.widths = {1, 4, 8, 16};
    auto result = link::linkShaders(diags, context, {stcPath.str().str()}, options, *target);
    REQUIRE(result);
    REQUIRE(emitModule(diags, *result->module, *target, OutputKind::SharedLibrary, soPath));
    void *handle = dlopen(soPath.c_str(), RTLD_NOW | RTLD_LOCAL);
    INFO(dlerror());
    REQUIRE(handle);
    llvm::sys::fs::remove(stcPath);
    llvm::sys::fs::remove(soPath);
    return static_cast<const AnyslLibraryInfo *>(dlsym(handle, ANYSL_LIBRARY_SYMBOL));
  }();
  return loaded;
}

constexpr unsigned pointCount = 48;
constexpr float untouched = -1;

/// A batch whose arrays are as long as the interface promises, and no longer.
struct Batch {
  std::array<std::array<float, pointCount>, 3> in, out;
  std::array<void *, ANYSL_COMPONENT_COUNT> globals{};
  AnyslServices services{};
  AnyslShadeArgs args{};

  Batch() {
    for (unsigned c = 0; c < 3; ++c) {
      for (unsigned i = 0; i < pointCount; ++i)
        in[c][i] = float(i + 100 * c);
      out[c].fill(untouched);
      globals[ANYSL_COMPONENT_Cs + c] = in[c].data();
      globals[ANYSL_COMPONENT_Ci + c] = out[c].data();
    }
    services.struct_size = sizeof services;
    args.struct_size = sizeof args;
    args.count = pointCount;
    args.globals = globals.data();
    args.services = &services;
  }
};

} // namespace

TEST_CASE("the descriptor says what is there") {
  const AnyslLibraryInfo *info = library();
  REQUIRE(info);
  CHECK(info->magic == ANYSL_MAGIC);
  CHECK(info->abi_version == ANYSL_ABI_VERSION);
  CHECK(info->struct_size == sizeof(AnyslLibraryInfo));
  CHECK(info->layout == ANYSL_LAYOUT_SOA);
  CHECK(info->real == ANYSL_REAL_FLOAT);
  CHECK(info->component_count == ANYSL_COMPONENT_COUNT);
  CHECK(info->runtime == std::string("packet"));
  REQUIRE(info->shader_count == 1);
  const AnyslShaderInfo &shader = info->shaders[0];
  CHECK(shader.name == std::string("square"));
  CHECK(shader.kind == ANYSL_SURFACE);
  CHECK(shader.globals_read == uint64_t(1) << ANYSL_Cs);
  CHECK(shader.globals_written == uint64_t(1) << ANYSL_Ci);
  CHECK(shader.services == 0);
  CHECK(shader.param_count == 0);
  REQUIRE(shader.entry_count == 4);
  for (unsigned i = 0; i < 4; ++i)
    CHECK(shader.entries[i].width == std::array<unsigned, 4>{1, 4, 8, 16}[i]);
}

TEST_CASE("an entry shades exactly the points of its range") {
  const AnyslShaderInfo &shader = library()->shaders[0];
  for (unsigned e = 0; e < shader.entry_count; ++e)
    for (unsigned first = 0; first <= 20; ++first)
      for (unsigned last = 0; last <= pointCount; ++last) {
        Batch batch;
        shader.entries[e].shade(&batch.args, first, last);
        bool right = true;
        for (unsigned c = 0; c < 3; ++c)
          for (unsigned i = 0; i < pointCount; ++i) {
            float in = batch.in[c][i];
            right &= batch.out[c][i] == (i >= first && i < last ? in * in : untouched);
          }
        INFO("width " << shader.entries[e].width << ", points " << first << " to " << last);
        CHECK(right);
      }
}

TEST_CASE("a range at the end of the numbers ends") {
  const AnyslShaderInfo &shader = library()->shaders[0];
  for (unsigned e = 0; e < shader.entry_count; ++e) {
    Batch batch;
    shader.entries[e].shade(&batch.args, UINT32_MAX, UINT32_MAX);
    shader.entries[e].shade(&batch.args, UINT32_MAX, 0);
    CHECK(batch.out[0][0] == untouched);
  }
}
