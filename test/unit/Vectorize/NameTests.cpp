//===-- test/unit/Vectorize/NameTests.cpp - names and signatures of variants ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/VectorAbi.h"

#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"

#include <catch2/catch.hpp>

using namespace anysl;
using Kind = VariantParam::Kind;

TEST_CASE("a variant's name says instruction set, mask, width and parameters", "[abi]") {
  auto name = parseVariantName("_ZGVdM8uvl4ln12ls1l_some_name");
  REQUIRE(name);
  CHECK(name->isa == Isa::Avx2);
  CHECK(name->masked);
  CHECK(name->width == 8);
  REQUIRE(name->params.size() == 6);
  CHECK(name->params[0].kind == Kind::Uniform);
  CHECK(name->params[1].kind == Kind::Vector);
  CHECK(name->params[2].kind == Kind::Linear);
  CHECK(name->params[2].step == 4);
  CHECK(name->params[3].step == -12);
  CHECK(name->params[4].kind == Kind::LinearByParam);
  CHECK(name->params[4].step == 1);
  CHECK(name->params[5].step == 1);
  CHECK(name->scalarName == "some_name");
  CHECK(name->functionName == "_ZGVdM8uvl4ln12ls1l_some_name");
}

TEST_CASE("a variant's function may have a name of its own", "[abi]") {
  auto name = parseVariantName("_ZGV_LLVM_N16v_f.point(f_x16)");
  REQUIRE(name);
  CHECK(name->isa == Isa::Llvm);
  CHECK_FALSE(name->masked);
  CHECK(name->width == 16);
  CHECK(name->scalarName == "f.point");
  CHECK(name->functionName == "f_x16");
}

TEST_CASE("what is no variant of x86 is not taken for one", "[abi]") {
  for (const char *text :
       {"", "f", "_ZGV", "_ZGVd", "_ZGVdN", "_ZGVdN8", "_ZGVdN8v", "_ZGVdN8v_", "_ZGVdX8v_f",
        "_ZGVdN7v_f", "_ZGVdN0v_f", "_ZGVdN1v_f", "_ZGVdN128v_f", "_ZGVnN4v_f", "_ZGVsMxv_f",
        "_ZGVdN8q_f", "_ZGVdN8lsv_f", "_ZGV_LLVM_Nxv_f", "_ZGVdN8v_f()"})
    CHECK_FALSE(parseVariantName(text));
}

static std::string signatureOf(const char *text, llvm::Type *result,
                               std::initializer_list<llvm::Type *> params) {
  auto name = parseVariantName(text);
  REQUIRE(name);
  std::string why;
  llvm::DataLayout layout("");
  auto signature = VariantSignature::get(
      *name, llvm::FunctionType::get(result, llvm::ArrayRef(params.begin(), params.size()), false),
      layout, why);
  if (!signature)
    return why;
  std::string printed;
  llvm::raw_string_ostream out(printed);
  signature->type()->print(out);
  return printed;
}

TEST_CASE("arguments are cut into registers of the instruction set", "[abi]") {
  llvm::LLVMContext context;
  llvm::Type *f = llvm::Type::getFloatTy(context), *d = llvm::Type::getDoubleTy(context);
  llvm::Type *i = llvm::Type::getInt32Ty(context), *v = llvm::Type::getVoidTy(context);
  llvm::Type *b = llvm::Type::getInt1Ty(context), *c = llvm::Type::getInt8Ty(context);
  auto *p = llvm::PointerType::getUnqual(context);
  CHECK(signatureOf("_ZGVdN8v_f", f, {f}) == "<8 x float> (<8 x float>)");
  CHECK(signatureOf("_ZGVdN8ul_f", f, {p, i}) == "<8 x float> (ptr, i32)");
  // AVX has 256 bits for floating point only.
  CHECK(signatureOf("_ZGVcN8vv_f", f, {f, i}) == "<8 x float> (<8 x float>, <4 x i32>, <4 x i32>)");
  // A result of several registers comes back through memory.
  CHECK(signatureOf("_ZGVbN4v_f", d, {d}) == "void (ptr, <2 x double>, <2 x double>)");
  // Masks: vectors of the result's type, or of the first varying parameter's; bits on AVX-512.
  CHECK(signatureOf("_ZGVdM4v_f", d, {f}) == "<4 x double> (<4 x float>, <4 x double>)");
  CHECK(signatureOf("_ZGVdM8v_f", v, {i}) == "void (<8 x i32>, <8 x i32>)");
  CHECK(signatureOf("_ZGVeM16v_f", f, {f}) == "<16 x float> (<16 x float>, i32)");
  CHECK(signatureOf("_ZGVeM16v_f", c, {i}) == "<16 x i8> (<16 x i32>, i64)");
  CHECK(signatureOf("_ZGVdN8v_f", b, {b}) == "<8 x i8> (<8 x i8>)");
  CHECK(signatureOf("_ZGV_LLVM_M8v_f", b, {d}) == "<8 x i1> (<8 x double>, <8 x i1>)");
}

TEST_CASE("a name that does not fit its function is refused", "[abi]") {
  llvm::LLVMContext context;
  llvm::Type *f = llvm::Type::getFloatTy(context), *i = llvm::Type::getInt32Ty(context);
  CHECK(signatureOf("_ZGVdN8vv_f", f, {f}) == "its parameters do not match the variant's name");
  CHECK(signatureOf("_ZGVdN8l_f", f, {f}) ==
        "a parameter that is neither integer nor pointer cannot be linear");
  CHECK(signatureOf("_ZGVdN8vls5_f", f, {f, i}) ==
        "only an integer parameter can be linear by another one");
  CHECK(signatureOf("_ZGVdN8v_f", f, {llvm::Type::getFP128Ty(context)}) ==
        "the vector ABI has no form for one of its parameters");
}
