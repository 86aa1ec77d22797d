//===-- test/unit/STC/VerifierTest.cpp - every rule has something that breaks it ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Each case is the text of a good module with one thing replaced.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Verifier.h"
#include "test/unit/STC/Samples.h"
#include <catch2/catch.hpp>

using namespace anysl::stc;

namespace {

constexpr const char *good = R"stc(
@anysl_type_float = external global i8
@anysl_type_color = external global i8
@text = private constant [4 x i8] c"hsv\00"

define void @s(ptr %ctx) !dbg !10 {
entry:
  %a = call ptr @anysl_alloc(ptr @anysl_type_float), !dbg !11
  %c = call ptr @anysl_alloc(ptr @anysl_type_color), !dbg !11
  %v = call ptr @anysl_alloc_array(ptr @anysl_type_float, i32 3), !dbg !11
  %e = call ptr @anysl_element(ptr %v, ptr @anysl_type_float, i32 3, i32 1), !dbg !11
  call void @anysl_load_param_float(ptr %a, ptr %ctx, i32 0), !dbg !11
  call void @anysl_add_float(ptr %e, ptr %a, ptr %a), !dbg !11
  call void @anysl_splat_color(ptr %c, ptr %e), !dbg !11
  %t = call i1 @anysl_lt_float(ptr %a, ptr %e), !dbg !11
  %n = xor i1 %t, true
  br i1 %n, label %then, label %end
then:
  call void @helper(ptr %c), !dbg !11
  br label %end
end:
  call void @anysl_store_global_color(ptr %ctx, i32 6, ptr %c), !dbg !11
  ret void
}

define void @s.init(ptr %ctx) !dbg !12 {
  %a = call ptr @anysl_alloc(ptr @anysl_type_float), !dbg !13
  call void @anysl_const_float(ptr %a, double 1.0), !dbg !13
  call void @anysl_store_param_float(ptr %ctx, i32 0, ptr %a), !dbg !13
  ret void
}

define internal void @helper(ptr %c) !dbg !14 !anysl.signature !20 {
  call void @anysl_neg_color(ptr %c, ptr %c), !dbg !15
  ret void
}

declare ptr @anysl_alloc(ptr)
declare ptr @anysl_alloc_array(ptr, i32)
declare ptr @anysl_element(ptr, ptr, i32, i32)
declare void @anysl_load_param_float(ptr, ptr, i32)
declare void @anysl_store_param_float(ptr, i32, ptr)
declare void @anysl_add_float(ptr, ptr, ptr)
declare void @anysl_splat_color(ptr, ptr)
declare void @anysl_neg_color(ptr, ptr)
declare i1 @anysl_lt_float(ptr, ptr)
declare void @anysl_store_global_color(ptr, i32, ptr)
declare void @anysl_const_float(ptr, double)

!anysl.stc = !{!0}
!anysl.shaders = !{!1}
!llvm.dbg.cu = !{!5}
!llvm.module.flags = !{!7}
!0 = !{i32 1, !"test"}
!1 = !{!"s", !"surface", ptr @s, ptr @s.init, !2, !3}
!2 = !{!4}
!3 = !{!{i32 6, i1 false, i1 true}}
!4 = !{!"Kd", !"float", !"uniform", i1 false, i32 0, i32 0}
!5 = distinct !DICompileUnit(language: DW_LANG_C, file: !6, isOptimized: true, runtimeVersion: 0, emissionKind: NoDebug)
!6 = !DIFile(filename: "s.sl", directory: "")
!7 = !{i32 2, !"Debug Info Version", i32 3}
!8 = !DISubroutineType(types: !9)
!9 = !{}
!10 = distinct !DISubprogram(name: "s", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!11 = !DILocation(line: 4, column: 7, scope: !10)
!12 = distinct !DISubprogram(name: "i", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!13 = !DILocation(line: 5, column: 1, scope: !12)
!14 = distinct !DISubprogram(name: "h", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!15 = !DILocation(line: 6, column: 1, scope: !14)
!20 = !{!"InOut(color)"}
)stc";

/// The text with the first occurrence of `from` replaced.
std::string replaced(const std::string &from, const std::string &to) {
  std::string text = good;
  size_t position = text.find(from);
  REQUIRE(position != std::string::npos);
  return text.replace(position, from.size(), to);
}

struct Case {
  const char *what;
  const char *from;
  const char *to;
  const char *message;
  unsigned line = 0; ///< of the shader; 0: the message names no place in it
};

const Case cases[] = {
    // The module
    {"a version from the future", "!{i32 1, !\"test\"}", "!{i32 9, !\"test\"}", "version 9"},
    {"no STC metadata", "!anysl.stc = !{!0}", "", "not subroutine-threaded code"},
    {"a target", "@anysl_type_float =", "target triple = \"x86_64-linux\"\n@anysl_type_float =",
     "names no target"},
    {"inline assembly of the module",
     "@anysl_type_float =", "module asm \"nop\"\n@anysl_type_float =", "inline assembly"},
    {"a variable", "@text = private constant", "@text = private global",
     "neither a type nor constant"},
    {"text without an end", "c\"hsv\\00\"", "c\"hsv!\"", "neither a type nor constant"},
    {"an unknown type",
     "@text =", "@anysl_type_quaternion = external global i8\n@text =", "names no type"},
    {"a type of another shape", "@anysl_type_float = external global i8",
     "@anysl_type_float = external global i32", "must be an external i8"},
    {"an alias", "@text =", "@other = alias void (ptr), ptr @s\n@text =", "aliases"},
    // Functions
    {"an unknown operator", "declare void @anysl_const_float(ptr, double)",
     "declare void @anysl_const_float(ptr, double)\ndeclare void @anysl_frobnicate(ptr)",
     "'anysl_frobnicate' is no operator"},
    {"a foreign function", "declare void @anysl_const_float(ptr, double)",
     "declare void @anysl_const_float(ptr, double)\ndeclare i32 @system(ptr)",
     "'system' is no operator"},
    {"an operator of another signature", "declare void @anysl_neg_color(ptr, ptr)",
     "declare void @anysl_neg_color(ptr, ptr) nounwind", "attributes"},
    {"a function that nobody describes",
     "define internal void @helper(ptr %c) !dbg !14 !anysl.signature !20",
     "define internal void @helper(ptr %c) !dbg !14", "'helper' is no operator"},
    {"a false description", "!20 = !{!\"InOut(color)\"}", "!20 = !{!\"InOut(color)\", !\"Ctx\"}",
     "does not have the parameters"},
    {"a nonsensical description", "!20 = !{!\"InOut(color)\"}", "!20 = !{!\"Sideways(color)\"}",
     "does not have the parameters"},
    // Instructions
    {"a load", "%n = xor i1 %t, true", "%l = load i32, ptr %a, !dbg !11\n %n = xor i1 %t, true",
     "LLVM's 'load'", 4},
    {"a store", "%n = xor i1 %t, true", "store i32 1, ptr %a, !dbg !11\n %n = xor i1 %t, true",
     "LLVM's 'store'", 4},
    {"an alloca", "%n = xor i1 %t, true", "%l = alloca i32, !dbg !11\n %n = xor i1 %t, true",
     "LLVM's 'alloca'", 4},
    {"pointer arithmetic", "%n = xor i1 %t, true",
     "%l = getelementptr i8, ptr %a, i32 4, !dbg !11\n %n = xor i1 %t, true",
     "LLVM's 'getelementptr'", 4},
    {"inline assembly", "%n = xor i1 %t, true",
     "call void asm sideeffect \"nop\", \"\"(), !dbg !11\n %n = xor i1 %t, true", "operand", 4},
    {"an undefined value", "%n = xor i1 %t, true", "%n = xor i1 %t, undef, !dbg !11",
     "no variable, number", 4},
    {"overflow flags", "%n = xor i1 %t, true",
     "%l = add nsw i32 1, 2, !dbg !11\n %n = xor i1 %t, true", "overflow flags", 4},
    {"a wide counter", "%n = xor i1 %t, true", "%l = add i64 1, 2, !dbg !11\n %n = xor i1 %t, true",
     "counters are i32", 4},
    {"unreachable", "br label %end", "unreachable", "LLVM's 'unreachable'"},
    // Calls
    {"a call without a place", "call void @anysl_splat_color(ptr %c, ptr %e), !dbg !11",
     "call void @anysl_splat_color(ptr %c, ptr %e)", ""},
    {"a call with attributes", "call void @anysl_splat_color(ptr %c, ptr %e)",
     "call void @anysl_splat_color(ptr noalias %c, ptr %e)", "attributes", 4},
    {"an operand of another type", "@anysl_splat_color(ptr %c, ptr %e)",
     "@anysl_splat_color(ptr %e, ptr %e)", "is a float, not a color", 4},
    {"an array for a value", "@anysl_splat_color(ptr %c, ptr %e)",
     "@anysl_splat_color(ptr %c, ptr %v)", "an array of another length", 4},
    {"the context for a value", "@anysl_splat_color(ptr %c, ptr %e)",
     "@anysl_splat_color(ptr %c, ptr %ctx)", "is no variable", 4},
    {"a value for the context", "@anysl_load_param_float(ptr %a, ptr %ctx, i32 0)",
     "@anysl_load_param_float(ptr %a, ptr %a, i32 0)", "is not the context", 4},
    {"null for a value", "@anysl_splat_color(ptr %c, ptr %e)",
     "@anysl_splat_color(ptr %c, ptr null)", "operand", 4},
    {"an allocation of no type", "@anysl_alloc(ptr @anysl_type_color)", "@anysl_alloc(ptr @text)",
     "is no type", 4},
    {"an absurd array", "@anysl_alloc_array(ptr @anysl_type_float, i32 3)",
     "@anysl_alloc_array(ptr @anysl_type_float, i32 2000000000)", "length is not in", 4},
    {"an element of another length", "ptr @anysl_type_float, i32 3, i32 1",
     "ptr @anysl_type_float, i32 4, i32 1", "own type and length", 4},
    {"an allocation in a loop", "call void @helper(ptr %c), !dbg !11",
     "%x = call ptr @anysl_alloc(ptr @anysl_type_float), !dbg !11\n call void @helper(ptr %c), "
     "!dbg !11",
     "outside the entry block", 4},
    // What the metadata must agree with
    {"a cell that is not there", "ptr %ctx, i32 0), !dbg !11", "ptr %ctx, i32 5), !dbg !11",
     "no parameter cell 5", 4},
    {"a global that is not there", "ptr %ctx, i32 6,", "ptr %ctx, i32 600,",
     "no shader global number 600", 4},
    {"a global that is not declared", "ptr %ctx, i32 6,", "ptr %ctx, i32 7,",
     "does not say that it writes 'Oi'", 4},
    {"a global of another type", "!{i32 6, i1 false, i1 true}", "!{i32 8, i1 false, i1 true}", "",
     0},
    {"a parameter of another type", "!\"Kd\", !\"float\"", "!\"Kd\", !\"string\"",
     "is a string, not a float", 4},
    {"an unknown kind", "!\"s\", !\"surface\"", "!\"s\", !\"sofa\"", "malformed STC metadata"},
    {"no body", "ptr @s, ptr @s.init", "ptr @anysl_alloc, ptr @s.init", "malformed STC metadata"},
    {"a shared function", "ptr @s, ptr @s.init", "ptr @s, ptr @s", "two functions"},
    {"an absurd parameter", "i1 false, i32 0, i32 0}", "i1 false, i32 -1, i32 0}", "absurd size"},
    {"overlapping parameters", "!2 = !{!4}",
     "!2 = !{!4, !{!\"K\", !\"float\", !\"uniform\", i1 false, i32 0, i32 0}}", "overlap"},
    {"an input in the defaults", "call void @anysl_const_float(ptr %a, double 1.0), !dbg !13",
     "call void @anysl_load_global_float(ptr %a, ptr %ctx, i32 8), !dbg !13", ""},
};

} // namespace

TEST_CASE("the module that the cases break is good") {
  llvm::LLVMContext context;
  auto result = sample::read(context, good);
  INFO(result.firstError());
  CHECK(result.module);
}

TEST_CASE("every broken rule is reported, with its place") {
  for (const Case &broken : cases) {
    llvm::LLVMContext context;
    auto result = sample::read(context, replaced(broken.from, broken.to));
    INFO(broken.what);
    CHECK_FALSE(result.module);
    REQUIRE(result.errors.size() == 1);
    CHECK_THAT(result.firstError(), Catch::Contains(broken.message));
    if (broken.line) {
      CHECK(result.errors[0].position.file == "s.sl");
      CHECK(result.errors[0].position.line == broken.line);
    }
  }
}
