//===-- lib/Link/Prune.cpp - leaves out what a scene does not call for --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Works on the threaded code, where an effect still is a call with a name and a place. Three things
// take a call away, and each is written down for the report: no way leads to it any more, since the
// constants of the scene decide a branch; the scene has nothing that it could ask for; nobody uses
// what it gives. What libraries call is left to the optimiser, with neutral operators in place of
// those that the scene does without (LinkModules.cpp).
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Prune.h"
#include "lib/Link/Needs.h"
#include "lib/Link/OperatorWriter.h"
#include "lib/STC/Asking.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/CFG.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"
#include "llvm/Transforms/Utils/Local.h"
#include <anysl/demand.h>

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

namespace {

/// Why something is not there whose cost is measured.
constexpr StringLiteral leftOut = "it is left out, whatever the scene calls for";

std::string join(const std::set<std::string> &texts) { return llvm::join(texts, ", "); }

class Pruner {
public:
  Pruner(Session &session, Shader &shader, const std::optional<std::set<std::string>> &asked,
         bool othersTrace)
      : session(session), shader(shader), asked(asked), othersTrace(othersTrace),
        body(*shader.info.body) {}

  void run() {
    if (session.options.scene) {
      foldBranches();
      dropOutputs();
    }
    leaveOutputsOut();
    dropUnused();
    shader.keepsOpacity = keepsOpacity(body);
    fixGlobals();
    noteGlobals();
  }

private:
  /// Notes a call for its own effect and for those that its operator leads to in the libraries.
  void note(const CallInst &call, bool isKept, const Twine &why,
            const std::set<std::string> &outputs = {}) {
    const stc::OpInfo *op = opOf(call);
    if (!op || op->purity == stc::Purity::Structural)
      return;
    auto [through, isNew] = throughOps.try_emplace(op->op);
    if (isNew)
      through->second = {effectsThrough(session, *call.getCalledFunction(), false),
                         effectsThrough(session, *call.getCalledFunction(), true)};
    for (unsigned effect = 1; effect < 32; ++effect) {
      bool isOwn = effect == unsigned(op->effect);
      if (!isOwn && !(through->second.all >> effect & 1))
        continue;
      bool isNeeded = isOwn || (through->second.needed >> effect & 1);
      shader.report.effectUses.push_back({nameOf(stc::Effect(effect), call, *op),
                                          op->name.str(),
                                          stc::positionOf(call),
                                          isKept && isNeeded,
                                          isKept && !isNeeded ? absenceOf(effect) : why.str(),
                                          {}});
      if (isKept && isNeeded)
        shader.report.effectUses.back().outputs.assign(outputs.begin(), outputs.end());
    }
  }

  /// An effect's name; each input and each output is an effect of its own: "Inputs.N".
  std::string nameOf(stc::Effect effect, const CallInst &call, const stc::OpInfo &op) const {
    std::string name = stc::nameOf(effect).str();
    auto kind =
        effect == stc::Effect::Inputs || effect == stc::Effect::Outputs ? idKind(op) : std::nullopt;
    if (kind == stc::IdKind::Global)
      return name + "." + stc::globalNumbered(unsigned(idOf(call, op)))->name.str();
    if (kind == stc::IdKind::Param)
      return name + "." + shader.info.params[idOf(call, op)].name;
    return name;
  }

  /// Why the scene does without an effect.
  std::string absenceOf(unsigned effect) const {
    for (const stc::OpInfo &op : stc::allOps())
      if (unsigned(op.effect) == effect)
        if (auto why = unneededIn(session, op.op))
          return *why;
    return "nothing of it is left";
  }

  /// Makes branches of constant conditions go one way, and takes away what no way leads to.
  void foldBranches() {
    SlotConstants constants(
        body, session.real,
        [this, scene = sceneOracle(session)](const CallInst &call, const stc::OpInfo &op) {
          const auto *value = fixedValue(call, op);
          return value ? SlotConstants::Known{std::nullopt,
                                              SlotValue{{value->begin(), value->end()}, "", {}},
                                              causeOf(call, op, *value)}
                       : scene(call, op);
        });
    std::map<BasicBlock *, std::string> whyNot;
    SmallVector<std::pair<BranchInst *, bool>> decided;
    const DominatorTree dominators(body);
    for (BasicBlock &block : body) {
      auto *branch = dyn_cast<BranchInst>(block.getTerminator());
      if (!constants.isReached(&block) || !branch || !branch->isConditional())
        continue;
      auto *truth = dyn_cast_or_null<ConstantInt>(constants.constantOf(branch->getCondition()));
      if (!truth)
        continue;
      decided.push_back({branch, !truth->isZero()});
      std::string why = join(constants.causesOf(branch->getCondition()));
      BasicBlock *taken = branch->getSuccessor(truth->isZero() ? 1 : 0);
      if (taken->getSinglePredecessor() == &block)
        for (BasicBlock &other : body)
          if (dominators.dominates(taken, &other))
            for (const std::string &cause : constants.causesOf(branch->getCondition()))
              because[&other].insert(cause);
      SmallVector<BasicBlock *> worklist{branch->getSuccessor(truth->isZero() ? 0 : 1)};
      while (!worklist.empty()) {
        BasicBlock *next = worklist.pop_back_val();
        if (constants.isReached(next) || !whyNot.try_emplace(next, why).second)
          continue;
        append_range(worklist, successors(next));
      }
    }
    for (auto &[block, why] : whyNot)
      for (Instruction &instruction : *block)
        if (auto *call = dyn_cast<CallInst>(&instruction))
          note(*call, false, "never reached: " + (why.empty() ? "always so" : why));
    for (auto [branch, truth] : decided)
      branch->setCondition(ConstantInt::getBool(session.context, truth));
    for (BasicBlock &block : body)
      ConstantFoldTerminator(&block, /*DeleteDeadConditions=*/false);
    removeUnreachableBlocks(body);
    for (Instruction &instruction : make_early_inc_range(instructions(body)))
      if (auto *call = dyn_cast<CallInst>(&instruction); call && !call->getType()->isVoidTy())
        if (Constant *constant = constants.constantOf(call); constant && unneededCall(*call))
          call->replaceAllUsesWith(constant);
  }

  bool unneededCall(const CallInst &call) const {
    const stc::OpInfo *op = opOf(call);
    return op && sceneOracle(session)(call, *op);
  }

  /// Outputs that nobody looks at are not stored: output parameters that no shader asks for either,
  /// and a surface's Ci or Oi.
  void dropOutputs() {
    const demand::Demand &scene = *session.options.scene;
    if (scene.outputs && asked)
      for (unsigned i = 0; i < shader.info.params.size(); ++i) {
        const stc::ParamInfo &param = shader.info.params[i];
        if (param.output && !is_contained(*scene.outputs, param.name) &&
            !asked->contains(param.name))
          dropStores(stc::IdKind::Param, i, param.name, unseen(param.name));
      }
    if (shader.info.kind == stc::ShaderKind::Surface)
      for (unsigned global : {ANYSL_Ci, ANYSL_Oi})
        if (StringRef name = stc::globalNumbered(global)->name; !scene.looksAt(name))
          dropStores(stc::IdKind::Global, global, name, unseen(name));
  }

  static std::string unseen(StringRef output) { return ("nobody looks at '" + output + "'").str(); }

  /// Whatever the scene calls for.
  void leaveOutputsOut() {
    for (const std::string &name : session.options.withoutOutputs) {
      for (unsigned i = 0; i < shader.info.params.size(); ++i)
        if (shader.info.params[i].name == name)
          dropStores(stc::IdKind::Param, i, name, leftOut);
      for (const stc::GlobalVariableInfo &global : stc::allGlobals())
        if (global.name == name)
          dropStores(stc::IdKind::Global, global.id, name, leftOut);
    }
    auto &dropped = shader.report.droppedOutputs;
    llvm::sort(dropped);
    dropped.erase(unique(dropped), dropped.end());
  }

  void dropStores(stc::IdKind kind, uint64_t id, StringRef name, StringRef why) {
    for (Instruction &instruction : make_early_inc_range(instructions(body))) {
      const stc::OpInfo *op = opOf(instruction);
      if (!op || op->purity != stc::Purity::Writes || idKind(*op) != kind)
        continue;
      auto &call = cast<CallInst>(instruction);
      if (idOf(call, *op) != id)
        continue;
      note(call, false, why);
      call.eraseFromParent();
      shader.report.droppedOutputs.push_back(name.str());
    }
  }

  /// Whether something is done for others than this function.
  static bool isRoot(const Instruction &instruction) {
    const stc::OpInfo *op = opOf(instruction);
    return (isa<CallInst>(instruction) && !op) ||
           (op && (op->purity == stc::Purity::Writes || op->op == Op::call_method));
  }

  /// Takes away what computes nothing that is used, and branches that decide nothing.
  void dropUnused() {
    const Needs needs(body);
    // Lights that shine on a point number its rays on, and so does the volume in front of it.
    const Needs::Instructions live = needs.of(isRoot, othersTrace);
    SmallVector<std::pair<BranchInst *, BasicBlock *>> undecided;
    for (Instruction &instruction : make_early_inc_range(instructions(body))) {
      if (live.contains(&instruction))
        continue;
      if (auto *branch = dyn_cast<BranchInst>(&instruction)) {
        undecided.push_back({branch, needs.meeting(*branch)});
        continue;
      }
      if (auto *call = dyn_cast<CallInst>(&instruction))
        note(*call, false, "nothing uses its result");
      instruction.replaceAllUsesWith(PoisonValue::get(instruction.getType()));
      instruction.eraseFromParent();
    }
    for (auto [branch, meeting] : undecided)
      goTo(*branch, *meeting);
    removeUnreachableBlocks(body);
  }

  /// Makes a branch lead to one place whatever its condition.
  static void goTo(BranchInst &branch, BasicBlock &target) {
    BasicBlock *block = branch.getParent();
    bool isKnown = false;
    for (BasicBlock *successor : branch.successors()) {
      if (successor == &target && !isKnown)
        isKnown = true;
      else
        successor->removePredecessor(block, /*KeepOneInputPHIs=*/true);
    }
    assert((isKnown || target.phis().empty()) && "a value depends on the way here");
    DebugLoc location = branch.getDebugLoc();
    BranchInst::Create(&target, branch.getIterator())->setDebugLoc(location);
    branch.eraseFromParent();
  }

  /// The outputs for which each instruction of the body is there.
  std::map<const Instruction *, std::set<std::string>> findOutputs() const {
    const Needs needs(body);
    std::map<std::string, Needs::Instructions> stores;
    for (const Instruction &instruction : instructions(body)) {
      const stc::OpInfo *op = opOf(instruction);
      auto kind = op ? idKind(*op) : std::nullopt;
      if (!op || op->purity != stc::Purity::Writes || !kind)
        continue;
      uint64_t id = idOf(cast<CallInst>(instruction), *op);
      if (*kind == stc::IdKind::Global)
        stores[stc::globalNumbered(unsigned(id))->name.str()].insert(&instruction);
      else if (*kind == stc::IdKind::Param)
        stores[shader.info.params[id].name].insert(&instruction);
    }
    std::map<const Instruction *, std::set<std::string>> result;
    for (const auto &[name, its] : stores)
      for (const Instruction *needed :
           needs.of([&its](const Instruction &instruction) { return its.contains(&instruction); },
                    false))
        result[needed].insert(name);
    return result;
  }

  /// What a call gives that loads a global which is the same at all points; null: something else.
  const std::array<double, 3> *fixedValue(const CallInst &call, const stc::OpInfo &op) const {
    if (!session.options.scene || shader.info.kind != stc::ShaderKind::Surface ||
        op.op != Op::load_global_color)
      return nullptr;
    const auto &globals = session.options.scene->globals;
    auto found = globals.find(stc::globalNumbered(unsigned(idOf(call, op)))->name.str());
    return found == globals.end() ? nullptr : &found->second;
  }

  /// "Os = (1, 1, 1)".
  std::string causeOf(const CallInst &call, const stc::OpInfo &op,
                      const std::array<double, 3> &value) const {
    std::string result = stc::globalNumbered(unsigned(idOf(call, op)))->name.str();
    raw_string_ostream stream(result);
    stream << format(" = (%g, %g, %g)", value[0], value[1], value[2]) << " everywhere";
    return result;
  }

  /// Makes such loads constants.
  void fixGlobals() {
    OperatorWriter writer(*body.getParent());
    for (Instruction &instruction : make_early_inc_range(instructions(body))) {
      const stc::OpInfo *op = opOf(instruction);
      if (!op)
        continue;
      auto &call = cast<CallInst>(instruction);
      const auto *value = fixedValue(call, *op);
      if (!value)
        continue;
      std::string cause = causeOf(call, *op, *value);
      note(call, false, cause);
      session.fixedGlobals[unsigned(idOf(call, *op))] = *value;
      writer.before(call, cause);
      writer.construct(call.getArgOperand(0), stc::Type::colorTy, *value);
      call.eraseFromParent();
    }
  }

  /// What is left, and the globals that are still asked for.
  void noteGlobals() {
    const auto outputs = findOutputs();
    for (stc::GlobalInfo &global : shader.info.globals)
      global.read = global.written = false;
    for (Function *function : reachable())
      for (Instruction &instruction : instructions(function)) {
        const stc::OpInfo *op = opOf(instruction);
        if (!op)
          continue;
        auto &call = cast<CallInst>(instruction);
        auto found = outputs.find(&call);
        auto cause = because.find(call.getParent());
        if (auto why = unneededIn(session, op->op))
          note(call, false, *why);
        else
          note(call, true, cause == because.end() ? "" : join(cause->second),
               found == outputs.end() ? std::set<std::string>() : found->second);
        if (idKind(*op) != stc::IdKind::Global)
          continue;
        for (stc::GlobalInfo &global : shader.info.globals)
          if (global.id == idOf(call, *op))
            (op->purity == stc::Purity::Writes ? global.written : global.read) = true;
      }
    erase_if(shader.info.globals,
             [](const stc::GlobalInfo &global) { return !global.read && !global.written; });
  }

  /// The body and the module's own functions that it calls.
  SmallSetVector<Function *, 8> reachable() { return reachableFrom({&body, shader.info.init}); }

  Session &session;
  Shader &shader;
  const std::optional<std::set<std::string>> &asked;
  bool othersTrace;
  Function &body;
  std::map<const BasicBlock *, std::set<std::string>> because; ///< what leads to a block
  struct Through {
    uint32_t all = 0, needed = 0; ///< bits 1 << effect
  };
  std::map<Op, Through> throughOps; ///< effects that operators lead to
};

} // namespace

std::optional<std::string> unneededIn(const Session &session, Op op) {
  if (session.options.withoutEffects >> unsigned(stc::info(op).effect) & 1)
    return leftOut.str();
  if (!session.options.scene)
    return std::nullopt;
  uint32_t assumes = session.options.scene->assumptions();
  switch (op) {
#define STC_UNNEEDED(name, assumption)                                                             \
  case Op::name:                                                                                   \
    if (assumes >> ANYSL_ASSUMES_##assumption & 1)                                                 \
      return absence(ANYSL_ASSUMES_##assumption);                                                  \
    return std::nullopt;
#include "lib/STC/Unneeded.def"
  default:
    return std::nullopt;
  }
}

std::string absence(unsigned assumption) {
  static const char *const names[] = {
#define ANYSL_ASSUMPTION(id, name, doc) doc,
#include <anysl/Assumptions.def>
  };
  return std::string("the scene does without ") + names[assumption];
}

SlotConstants::Oracle sceneOracle(const Session &session) {
  return [&session](const CallInst &call,
                    const stc::OpInfo &op) -> std::optional<SlotConstants::Known> {
    if (!session.options.scene)
      return std::nullopt;
    const demand::Demand &scene = *session.options.scene;
    if (auto why = unneededIn(session, op.op)) {
      SlotConstants::Known known{0, SlotValue{}, *why};
      // What it changes stays as it is.
      if (any_of(op.params, [](auto &param) { return param.kind == ParamKind::InOut; }))
        known.value.reset();
      return known;
    }
    uint32_t assumes = scene.assumptions();
    auto holds = [&](unsigned assumption) { return (assumes >> assumption & 1) != 0; };
    if (op.op == Op::load_global_float && idOf(call, op) == ANYSL_time &&
        holds(ANYSL_ASSUMES_NO_MOTION) && (*scene.shutter)[0] == 0)
      return SlotConstants::Known{std::nullopt, SlotValue{}, absence(ANYSL_ASSUMES_NO_MOTION)};
    if (idKind(op) == stc::IdKind::Query) {
      switch (idOf(call, op)) {
      case ANYSL_QUERY_displacement:
        if (holds(ANYSL_ASSUMES_NO_DISPLACEMENT))
          return SlotConstants::Known{0, std::nullopt, absence(ANYSL_ASSUMES_NO_DISPLACEMENT)};
        break;
      case ANYSL_QUERY_atmosphere:
      case ANYSL_QUERY_incident:
      case ANYSL_QUERY_opposite:
        if (holds(ANYSL_ASSUMES_NO_VOLUMES))
          return SlotConstants::Known{0, std::nullopt, absence(ANYSL_ASSUMES_NO_VOLUMES)};
        break;
      default:
        break;
      }
    }
    return std::nullopt;
  };
}

bool prune(Session &session) {
  const bool isMeasured = !session.options.withoutOutputs.empty();
  if (!session.options.scene && !isMeasured)
    return true;
  std::optional<std::set<std::string>> asked;
  if (session.options.scene)
    asked = askedNames(session);
  // What is measured is another picture anyhow: nothing has to stay for the sake of numbers.
  bool othersTrace =
      !isMeasured && (!(session.options.scene->assumptions() >> ANYSL_ASSUMES_NO_OTHER_RAYS & 1) ||
                      any_of(session.files, [](auto &file) { return stc::tracesForOthers(file); }));
  for (Shader &shader : session.shaders) {
    if (!noteSource(session, shader))
      return false;
    Pruner(session, shader, asked, othersTrace).run();
  }
  return true;
}

} // namespace anysl::link
