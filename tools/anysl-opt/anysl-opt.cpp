//===-- tools/anysl-opt/anysl-opt.cpp - a small opt with the project's passes -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Runs a pass pipeline over a module, as `opt` does. The passes are linked in, so that this works
// in sanitizer builds, whose plugin the distribution's opt cannot load.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Registry.h"

#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/Verifier.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/InitLLVM.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/TargetSelect.h"
#include "llvm/Support/ToolOutputFile.h"
#include "llvm/Support/WithColor.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

static cl::OptionCategory category("anysl-opt options");
static cl::opt<std::string> inputName(cl::Positional, cl::desc("<input .ll or .bc>"), cl::init("-"),
                                      cl::cat(category));
static cl::opt<std::string> outputName("o", cl::desc("Write to this file (default: -)"),
                                       cl::value_desc("file"), cl::init("-"), cl::cat(category));
static cl::opt<std::string> pipeline("passes", cl::desc("The passes to run, as opt's option"),
                                     cl::Required, cl::cat(category));
static cl::opt<bool> writeText("S", cl::desc("Write text instead of bitcode"), cl::cat(category));
static cl::opt<bool> noOutput("disable-output", cl::desc("Write nothing"), cl::cat(category));
static cl::opt<bool> verifyEach("verify-each", cl::desc("Verify after each pass"),
                                cl::cat(category));
static cl::opt<std::string> cpu("mcpu", cl::desc("The processor that costs are taken from"),
                                cl::init("x86-64"), cl::cat(category));

int main(int argc, char **argv) {
  InitLLVM init(argc, argv);
  InitializeNativeTarget();
  cl::HideUnrelatedOptions(category);
  cl::ParseCommandLineOptions(argc, argv, "AnySL's opt: runs LLVM's and AnySL's passes\n");

  LLVMContext context;
  SMDiagnostic problem;
  std::unique_ptr<Module> module = parseIRFile(inputName, problem, context);
  if (!module) {
    problem.print("anysl-opt", errs());
    return 1;
  }
  auto fail = [](const Twine &message) {
    WithColor::error(errs(), "anysl-opt") << message << "\n";
    return 1;
  };

  std::unique_ptr<TargetMachine> machine;
  std::string why;
  if (!module->getTargetTriple().empty())
    if (const Target *target = TargetRegistry::lookupTarget(module->getTargetTriple(), why))
      machine.reset(target->createTargetMachine(module->getTargetTriple(), cpu, "", {}, {}));

  LoopAnalysisManager loops;
  FunctionAnalysisManager functions;
  CGSCCAnalysisManager components;
  ModuleAnalysisManager modules;
  PassBuilder builder(machine.get());
  anysl::registerPasses(builder);
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(components);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, components, modules);
  ModulePassManager passes;
  if (Error error = builder.parsePassPipeline(passes, pipeline))
    return fail(toString(std::move(error)));
  if (verifyEach)
    passes.addPass(VerifierPass());
  passes.run(*module, modules);
  if (verifyModule(*module, &errs()))
    report_fatal_error("anysl-opt: the passes broke the module; please report this");

  if (noOutput)
    return 0;
  std::error_code code;
  ToolOutputFile output(outputName, code, writeText ? sys::fs::OF_Text : sys::fs::OF_None);
  if (code)
    return fail(outputName + ": " + code.message());
  if (writeText)
    module->print(output.os(), nullptr);
  else
    WriteBitcodeToFile(*module, output.os());
  output.keep();
  return 0;
}
