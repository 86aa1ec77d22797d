//===-- test/unit/Vectorize/Lanes.cpp - run scalar lanes beside a widened function ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Lanes.h"

#include "passes/Vectorize/Flags.h"
#include "passes/Vectorize/Vectorize.h"
#include "test/unit/Vectorize/Kernels.h"

#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/ExecutionEngine/Orc/LLJIT.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Verifier.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Support/TargetSelect.h"
#include "llvm/TargetParser/Host.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/IPO/Internalize.h"
#include "llvm/Transforms/Utils/Cloning.h"

#include <cfenv>
#include <cmath>
#include <cstring>
#include <random>

using namespace llvm;

/// What kernels may call: a function that nobody has a wide form of. It must run for active lanes
/// only.
extern "C" int anyslTestCalls;
int anyslTestCalls;
extern "C" int anyslTestOpaque(int x, float y);
int anyslTestOpaque(int x, float y) {
  ++anyslTestCalls;
  return int(unsigned(x) * 31) + (y > 0 ? 7 : -3);
}

/// What has variants beside it, which call it for active lanes.
extern "C" int anyslTestDeclared(int x, float y);
int anyslTestDeclared(int x, float y) {
  ++anyslTestCalls;
  return int(unsigned(x) * 17) ^ (y > 1 ? 5 : 80);
}

namespace anysl::test {

using Scalar = void (*)(Args *, int);
using Wide = void (*)(Args *, int, uint64_t);

bool canRun(StringRef cpu) {
  StringMap<bool> features = sys::getHostCPUFeatures();
  if (cpu == "x86-64-v4")
    return features.lookup("avx512f") && features.lookup("avx512vl") &&
           features.lookup("avx512dq") && features.lookup("avx512bw");
  if (cpu == "x86-64-v3")
    return features.lookup("avx2") && features.lookup("fma") && features.lookup("bmi2");
  return features.lookup("sse4.2");
}

//===-- Inputs --------------------------------------------------------------===//

template <typename T>
static T pick(std::mt19937_64 &random, std::initializer_list<T> values) {
  return values.begin()[random() % values.size()];
}

static float someFloat(std::mt19937_64 &random) {
  if (random() % 8 == 0)
    return pick<float>(random,
                       {0.f, -0.f, 1.f, -1.f, INFINITY, -INFINITY, NAN, 1e-42f, 3e38f, 0.5f});
  return std::uniform_real_distribution<float>(-4, 4)(random);
}

static int someInt(std::mt19937_64 &random) {
  if (random() % 16 == 0)
    return pick<int>(random, {0, 1, -1, INT32_MAX, INT32_MIN, 65536});
  return int(random() % 201) - 100;
}

static void fill(Args &args, std::mt19937_64 &random) {
  std::memset(&args, 0x5a, sizeof args);
  for (int k = 0; k < INPUTS; ++k)
    for (int lane = 0; lane < LANES; ++lane) {
      args.f[k][lane] = someFloat(random);
      args.d[k][lane] =
          random() % 8 ? std::uniform_real_distribution<double>(-4, 4)(random) : someFloat(random);
      args.i[k][lane] = someInt(random);
      args.l[k][lane] = random() % 8 ? someInt(random) : int64_t(random());
      args.s[k][lane] = short(random());
      args.b[k][lane] = uint8_t(random());
    }
  for (int lane = 0; lane < LANES; ++lane) {
    args.index[lane] = random() % TABLE;
    args.points[lane] = {someFloat(random), someFloat(random), someFloat(random), someInt(random)};
  }
  for (int k = 0; k < TABLE; ++k) {
    args.table[k] = someFloat(random);
    args.itable[k] = someInt(random);
  }
  args.n = random() % 13;
  args.m = random() % 13;
  args.uniform = someFloat(random);
}

/// What a lane that is not active must not stumble over.
static void spoil(Args &args, int lane) {
  for (int k = 0; k < INPUTS; ++k) {
    args.f[k][lane] = NAN;
    args.d[k][lane] = NAN;
    args.i[k][lane] = k == 0 ? INT32_MIN : k == 1 ? 0 : -1;
    args.l[k][lane] = k == 0 ? INT64_MIN : k == 1 ? 0 : -1;
    args.s[k][lane] = 0;
    args.b[k][lane] = 0;
  }
  args.index[lane] = 0x7ffffff0;
  args.points[lane] = {NAN, NAN, NAN, 0x7ffffff0};
}

//===-- Comparing -----------------------------------------------------------===//

static std::string show(const char *what, int k, int lane, double expected, double got) {
  char text[200];
  std::snprintf(text, sizeof text, "%s[%d] of lane %d is %.17g, should be %.17g", what, k, lane,
                got, expected);
  return text;
}

template <typename T, int N>
static std::string compareArrays(const char *what, const T (&expected)[N][LANES],
                                 const T (&got)[N][LANES]) {
  for (int k = 0; k < N; ++k)
    for (int lane = 0; lane < LANES; ++lane) {
      T a = expected[k][lane], b = got[k][lane];
      if (std::memcmp(&a, &b, sizeof a) != 0 && !(a != a && b != b))
        return show(what, k, lane, a, b);
    }
  return {};
}

static std::string compare(const Args &expected, const Args &got) {
  std::string difference = compareArrays("fo", expected.fo, got.fo);
  if (difference.empty())
    difference = compareArrays("dout", expected.dout, got.dout);
  if (difference.empty())
    difference = compareArrays("io", expected.io, got.io);
  if (difference.empty())
    difference = compareArrays("lo", expected.lo, got.lo);
  for (int lane = 0; lane < LANES && difference.empty(); ++lane) {
    if (expected.so[lane] != got.so[lane])
      difference = show("so", 0, lane, expected.so[lane], got.so[lane]);
    if (expected.bo[lane] != got.bo[lane])
      difference = show("bo", 0, lane, expected.bo[lane], got.bo[lane]);
    for (int k = 0; k < PRIVATE; ++k)
      if (expected.priv[lane][k] != got.priv[lane][k])
        difference = show("priv", k, lane, expected.priv[lane][k], got.priv[lane][k]);
  }
  if (difference.empty() && std::memcmp(&expected, &got, offsetof(Args, fo)) != 0)
    difference = "an input was changed";
  return difference;
}

//===-- Compiling -----------------------------------------------------------===//

/// The module with one kernel, made for a processor.
static std::unique_ptr<Module> isolate(const Module &module, StringRef name,
                                       const Comparison &how) {
  std::unique_ptr<Module> copy = CloneModule(module);
  for (Function &function : *copy) {
    function.removeFnAttr("target-features");
    function.removeFnAttr("tune-cpu");
    function.addFnAttr("target-cpu", how.cpu);
    function.removeFnAttr("min-legal-vector-width");
  }
  internalizeModule(*copy, [&](const GlobalValue &value) {
    // Variants that only an attribute names.
    return value.getName() == name || value.getName().starts_with("anyslTest");
  });
  PassBuilder passes;
  LoopAnalysisManager loops;
  FunctionAnalysisManager functions;
  CGSCCAnalysisManager components;
  ModuleAnalysisManager modules;
  passes.registerModuleAnalyses(modules);
  passes.registerCGSCCAnalyses(components);
  passes.registerFunctionAnalyses(functions);
  passes.registerLoopAnalyses(loops);
  passes.crossRegisterProxies(loops, functions, components, modules);
  ModulePassManager manager;
  manager.addPass(GlobalDCEPass());
  if (how.optimizeScalar)
    manager.addPass(passes.buildPerModuleDefaultPipeline(OptimizationLevel::O2));
  manager.run(*copy, modules);
  if (how.mindFlags)
    for (Function &function : *copy)
      if (!function.isDeclaration())
        anysl::mindFlags(function);
  return copy;
}

/// `void wrapper(args, lane, uint64_t mask)`, which a C++ program can call.
static void addWrapper(Module &module, StringRef wrapper, StringRef variant, bool masked,
                       unsigned width, StringRef cpu) {
  LLVMContext &context = module.getContext();
  IRBuilder<> builder(context);
  auto *type = FunctionType::get(
      builder.getVoidTy(), {builder.getPtrTy(), builder.getInt32Ty(), builder.getInt64Ty()}, false);
  Function *function = Function::Create(type, GlobalValue::ExternalLinkage, wrapper, module);
  function->addFnAttr("target-cpu", cpu);
  setVectorWidth(*function, std::min(512u, 64 * width));
  builder.SetInsertPoint(BasicBlock::Create(context, "", function));
  SmallVector<Value *, 3> arguments = {function->getArg(0), function->getArg(1)};
  if (masked)
    arguments.push_back(
        builder.CreateBitCast(builder.CreateTrunc(function->getArg(2), builder.getIntNTy(width)),
                              FixedVectorType::get(builder.getInt1Ty(), width)));
  builder.CreateCall(module.getFunction(variant), arguments);
  builder.CreateRetVoid();
}

std::string compareLanes(const Module &module, StringRef name, const Comparison &how) {
  static bool ready = !InitializeNativeTarget() && !InitializeNativeTargetAsmPrinter();
  if (!ready)
    return "no native target";
  std::unique_ptr<Module> isolated = isolate(module, name, how);
  Function *kernel = isolated->getFunction(name);
  if (!kernel)
    return "there is no kernel " + name.str();
  std::string lanes = std::to_string(how.width);
  std::string full = "_ZGV_LLVM_N" + lanes + "ul_" + name.str();
  std::string masked = "_ZGV_LLVM_M" + lanes + "ul_" + name.str();
  addVectorVariant(*kernel, full);
  addVectorVariant(*kernel, masked);

  VectorizeOptions options;
  options.width = how.width;
  options.verifyEach = true;
  std::string refused;
  options.onRemark = [&](const VectorizeRemark &remark) {
    if (remark.kind == VectorizeRemark::Kind::Refused)
      refused = remark.message;
  };
  defineVectorVariants(*isolated, options, nullptr);
  if (!refused.empty())
    return refused;
  addWrapper(*isolated, "runFull", full, false, how.width, how.cpu);
  addWrapper(*isolated, "runMasked", masked, true, how.width, how.cpu);
  std::string broken;
  raw_string_ostream out(broken);
  if (verifyModule(*isolated, &out))
    return broken;
  if (std::getenv("ANYSL_DUMP"))
    isolated->print(errs(), nullptr);

  // The module moves to a context of its own, as the JIT wants to own that.
  orc::JITTargetMachineBuilder machine{Triple(sys::getProcessTriple())};
  machine.setCPU(how.cpu);
  machine.setRelocationModel(Reloc::PIC_);
  machine.setCodeGenOptLevel(how.optimizeCode ? CodeGenOptLevel::Less : CodeGenOptLevel::None);
  auto made = orc::LLJITBuilder().setJITTargetMachineBuilder(std::move(machine)).create();
  if (!made)
    return toString(made.takeError());
  auto jit = std::move(*made);
  isolated->setDataLayout(jit->getDataLayout());
  SmallVector<char, 0> bitcode;
  raw_svector_ostream bitcodeOut(bitcode);
  WriteBitcodeToFile(*isolated, bitcodeOut);
  auto context = std::make_unique<LLVMContext>();
  auto read = parseBitcodeFile(MemoryBufferRef(bitcodeOut.str(), name), *context);
  if (!read)
    return toString(read.takeError());
  std::unique_ptr<Module> moved = std::move(*read);
  auto symbols = orc::DynamicLibrarySearchGenerator::GetForCurrentProcess(
      jit->getDataLayout().getGlobalPrefix());
  if (!symbols)
    return toString(symbols.takeError());
  jit->getMainJITDylib().addGenerator(std::move(*symbols));
  orc::SymbolMap own;
  own[jit->mangleAndIntern("anyslTestOpaque")] = {orc::ExecutorAddr::fromPtr(&anyslTestOpaque),
                                                  JITSymbolFlags::Exported};
  own[jit->mangleAndIntern("anyslTestDeclared")] = {orc::ExecutorAddr::fromPtr(&anyslTestDeclared),
                                                    JITSymbolFlags::Exported};
  if (Error error = jit->getMainJITDylib().define(orc::absoluteSymbols(own)))
    return toString(std::move(error));
  if (Error error = jit->addIRModule(orc::ThreadSafeModule(std::move(moved), std::move(context))))
    return toString(std::move(error));
  auto scalarSymbol = jit->lookup(name), fullSymbol = jit->lookup("runFull"),
       maskedSymbol = jit->lookup("runMasked");
  if (!scalarSymbol || !fullSymbol || !maskedSymbol)
    return "a function was not compiled";
  auto scalar = scalarSymbol->toPtr<Scalar>();
  auto runFull = fullSymbol->toPtr<Wide>(), runMasked = maskedSymbol->toPtr<Wide>();

  std::mt19937_64 random(how.seed);
  auto inputs = std::make_unique<Args>(), expected = std::make_unique<Args>(),
       got = std::make_unique<Args>();
  const uint64_t all = how.width == 64 ? ~0ull : (1ull << how.width) - 1;
  for (unsigned round = 0; round < how.rounds; ++round) {
    fill(*inputs, random);
    int first = (random() % (LANES / how.width)) * how.width;
    SmallVector<uint64_t, 8> masks = {all,
                                      all,
                                      random() & all,
                                      random() & random() & all,
                                      (random() | random()) & all,
                                      1ull << (random() % how.width)};
    if (round == 0)
      masks.push_back(0);
    for (unsigned trial = 0; trial < masks.size(); ++trial) {
      uint64_t mask = masks[trial];
      bool useFull = trial == 0;
      *expected = *inputs;
      for (unsigned lane = 0; lane < how.width; ++lane)
        if (!(mask >> lane & 1))
          spoil(*expected, first + lane);
      *got = *expected;
      anyslTestCalls = 0;
      std::feclearexcept(FE_ALL_EXCEPT);
      for (unsigned lane = 0; lane < how.width; ++lane)
        if (mask >> lane & 1)
          scalar(expected.get(), first + lane);
      int calls = std::exchange(anyslTestCalls, 0);
      int flags = std::fetestexcept(FE_ALL_EXCEPT);
      std::feclearexcept(FE_ALL_EXCEPT);
      (useFull ? runFull : runMasked)(got.get(), first, mask);
      int raised = std::fetestexcept(FE_ALL_EXCEPT);
      std::string difference = compare(*expected, *got);
      if (difference.empty() && how.mindFlags && flags != raised)
        difference = "exception flags are " + std::to_string(raised) + ", should be " +
                     std::to_string(flags);
      if (difference.empty() && calls != anyslTestCalls)
        difference = "an opaque function ran " + std::to_string(anyslTestCalls) +
                     " times, should run " + std::to_string(calls) + " times";
      if (!difference.empty()) {
        char head[200];
        std::snprintf(head, sizeof head,
                      "%s, %u lanes from %d, %s, mask %llx, round %u: ", name.str().c_str(),
                      how.width, first, useFull ? "N" : "M", (unsigned long long)mask, round);
        return head + difference;
      }
    }
  }
  return {};
}

} // namespace anysl::test
