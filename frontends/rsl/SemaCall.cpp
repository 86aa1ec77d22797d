//===-- frontends/rsl/SemaCall.cpp - which function a call means ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"

#include "lib/STC/Shader.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace anysl::rsl {

Type Sema::Candidate::type(size_t i) const {
  return function ? function->params[i]->type : Type{builtin->arguments[i].type};
}
bool Sema::Candidate::isIn(size_t i) const { return function || builtin->arguments[i].isIn; }
bool Sema::Candidate::isOut(size_t i) const {
  return function ? function->params[i]->isOutput : builtin->arguments[i].isOut;
}

std::string Sema::signature(const Candidate &candidate) {
  if (candidate.builtin)
    return rsl::signature(*candidate.builtin);
  const FunctionDecl &decl = *candidate.function;
  std::string text = toString(decl.result) + " " + decl.name.str() + "(";
  for (const VarDecl *param : decl.params)
    text += (param == decl.params[0] ? "" : ", ") + std::string(param->isOutput ? "output " : "") +
            toString(param->type);
  return text + ")";
}

//===-- What an expression's type is before its context is known --------------------------------//

/// The type that an expression has in any context; Error if that depends on the context, or is
/// unknown.
Type Sema::probe(Expr *expr) {
  if (!expr->isProbed) {
    expr->probed = probeInner(expr);
    expr->isProbed = true;
  }
  return expr->probed;
}

Type Sema::probeInner(Expr *expr) {
  switch (expr->kind) {
  case ExprKind::Number:
    return {TypeKind::Float};
  case ExprKind::String:
    return {TypeKind::String};
  case ExprKind::Name: {
    auto *name = cast<NameExpr>(expr);
    if (VarDecl *decl = lookup(name->name))
      return decl->type;
    return {name->name == "PI"     ? TypeKind::Float
            : name->name == "null" ? TypeKind::Shader
                                   : TypeKind::Error};
  }
  case ExprKind::Index: {
    Type base = probe(cast<IndexExpr>(expr)->base);
    return base.isTriple() ? Type{TypeKind::Float} : base.element();
  }
  case ExprKind::Member:
    return probeMember(*cast<MemberExpr>(expr));
  case ExprKind::Negate:
    return probe(cast<NegateExpr>(expr)->operand);
  case ExprKind::Not:
    return {TypeKind::Bool};
  case ExprKind::Binary: {
    auto *binary = cast<BinaryExpr>(expr);
    if (isComparison(binary->op) || isLogical(binary->op))
      return {TypeKind::Bool};
    if (binary->op == BinaryOp::Dot) {
      Expr *member = dotAsMember(*binary);
      return member ? probe(member) : Type{TypeKind::Float};
    }
    if (binary->op == BinaryOp::Cross)
      return {TypeKind::Vector};
    Type left = probe(binary->left), right = probe(binary->right);
    if (left.isError())
      return right.isTriple() || right.is(TypeKind::Matrix) ? right : Type();
    if (right.isError())
      return left.isTriple() || left.is(TypeKind::Matrix) ? left : Type();
    return {combinedKind(binary->op, left, right)};
  }
  case ExprKind::Conditional: {
    auto *conditional = cast<ConditionalExpr>(expr);
    Type a = probe(conditional->whenTrue), b = probe(conditional->whenFalse);
    if (a.isError() || b.isError())
      return a.isTriple() ? a : b.isTriple() ? b : Type();
    bool isWhole = a.structure || a.isArray();
    return isWhole || a.is(TypeKind::String) ? a : Type{combinedKind(BinaryOp::Add, a, b)};
  }
  case ExprKind::Assign:
    return probe(cast<AssignExpr>(expr)->target);
  case ExprKind::Tuple:
    return {cast<TupleExpr>(expr)->elements.size() == 16 ? TypeKind::Matrix : TypeKind::Error};
  case ExprKind::Cast:
    return {cast<CastExpr>(expr)->to};
  case ExprKind::Call: {
    auto *call = cast<CallExpr>(expr);
    if (call->object && !isThis(call->object) && probe(call->object).is(TypeKind::Shader))
      return {};
    splitNamed(*call);
    SmallVector<Type, 8> args;
    for (Expr *arg : call->args)
      args.push_back(probe(arg));
    if ((call->name == "min" || call->name == "max") && args.size() > 2 &&
        candidates(*call)[0].builtin) {
      Type kind = args[0];
      for (Type arg : args)
        kind = {combinedKind(BinaryOp::Add, kind, arg)};
      return kind;
    }
    if (isFlexible(*call, args))
      return {};
    if (std::optional<Candidate> chosen = choose(*call, args, TypeKind::Error))
      return chosen->resultType();
    if (StructDecl *structure = lookupStruct(call->name); structure && !call->object)
      return {TypeKind::Struct, true, Type::NoArray, structure};
    // Component by component: the type of the first triple.
    for (Type arg : args)
      if (arg.isTriple() && !builtinsNamed(call->name).empty())
        return arg;
    if (call->name == "getshader")
      return {TypeKind::Shader};
    if (call->name == "getshaders" || call->name == "getlights")
      return {TypeKind::Shader, false, options.arrayCapacity, nullptr, true};
    if (call->name == "pop" && args.size() == 1)
      return args[0].element();
    return {specialResult(call->name)};
  }
  case ExprKind::Comma:
    return probe(cast<CommaExpr>(expr)->elements.back());
  case ExprKind::List:
    return {};
  case ExprKind::Opaque:
    return expr->type;
  }
  llvm_unreachable("unknown expression");
}

/// Whether several overloads fit a call's arguments equally well and differ in their result.
bool Sema::isFlexible(CallExpr &call, ArrayRef<Type> args) {
  int best = INT_MAX;
  TypeKind result = TypeKind::Error;
  bool differs = false;
  for (const Candidate &candidate : candidates(call)) {
    int price = cost(candidate, call, args, TypeKind::Error);
    if (price < 0 || price > best)
      continue;
    differs = price == best && (differs || candidate.result() != result);
    best = price;
    result = candidate.result();
  }
  return differs;
}

//===-- Overloads -------------------------------------------------------------------------------//

/// The functions in scope that have a name, inner ones first, then the built-ins.
std::vector<Sema::Candidate> Sema::candidates(const CallExpr &call) {
  StringRef name = call.name;
  std::vector<Candidate> found;
  if (call.object) {
    // What has been checked may be several steps, which probe() does not know.
    const StructDecl *checked = call.object->type.structure;
    const StructDecl *owner = isThis(call.object) ? structure
                              : checked           ? checked
                                                  : probe(call.object).structure;
    if (owner)
      for (FunctionDecl *method : owner->methods)
        if (method->name == name)
          found.push_back({method, nullptr});
    return found;
  }
  for (Scope &scope : llvm::reverse(scopes)) {
    auto entry = scope.functions.find(name);
    if (entry == scope.functions.end())
      continue;
    for (FunctionDecl *decl : entry->second)
      if (!decl->defines) // the operator is called, whoever defines it in the end
        found.push_back({decl, nullptr});
    if (!found.empty())
      break;
  }
  for (const Builtin *builtin : builtinsNamed(name))
    found.push_back({nullptr, builtin});
  return found;
}

/// How badly an argument of a type fits a parameter; negative if not at all.
int Sema::argumentCost(const Candidate &candidate, size_t i, Type arg) {
  Type param = candidate.type(i);
  int total = 0;
  if (candidate.isIn(i)) {
    int price = conversionCost(arg, param);
    if (price < 0)
      return -1;
    total += price;
  }
  if (candidate.isOut(i)) {
    // What comes back must be of the same kind: a color gets no float.
    int price = param.isArray() ? conversionCost(arg, param) : conversionCost(param, arg);
    if (price < 0 || price > 4)
      return -1;
    total += price;
  }
  return total;
}

/// How badly a call fits an overload; negative if not at all. Unknown argument types fit numbers.
int Sema::cost(const Candidate &candidate, const CallExpr &call, ArrayRef<Type> args,
               TypeKind hint) {
  if (candidate.size() != args.size())
    return -1;
  if (!call.rest.empty() &&
      !(candidate.builtin && (candidate.builtin->named || candidate.builtin->takesRest)))
    return -1;
  int total = 0;
  for (size_t i = 0; i < args.size(); ++i) {
    Type param = candidate.type(i);
    if (args[i].isError()) {
      auto *inner = dyn_cast<CallExpr>(call.args[i]);
      bool isRemote = inner && inner->object; // another shader gives what is wanted
      bool fits = param.isNumeric() || param.isError() ||
                  (isRemote && (param.isArray() || param.structure));
      if (isa<TupleExpr>(call.args[i]))
        fits = param.isTriple();
      if (!fits)
        return -1;
      continue;
    }
    int price = argumentCost(candidate, i, args[i]);
    if (price < 0)
      return -1;
    total += price;
  }
  Type wanted = call.wanted.isError() ? Type{hint} : call.wanted;
  if (wanted.isError())
    return total;
  int price = conversionCost(candidate.resultType(), wanted);
  return total + (price < 0 ? 1000 : price);
}

/// The overload that fits best; the user's own functions go before built-ins of the same name.
std::optional<Sema::Candidate> Sema::choose(CallExpr &call, ArrayRef<Type> args, TypeKind hint) {
  std::optional<Candidate> best;
  int lowest = INT_MAX;
  for (const Candidate &candidate : candidates(call)) {
    if (candidate.builtin && best && best->function)
      break;
    int price = cost(candidate, call, args, hint);
    if (price >= 0 && price < lowest) {
      lowest = price;
      best = candidate;
    }
  }
  return best;
}

/// min and max of more than two arguments are calls inside of calls.
CallExpr *Sema::foldExtremes(CallExpr &call) {
  Expr *left = call.args[0];
  for (size_t i = 1; i + 1 < call.args.size(); ++i) {
    Expr *pair[] = {left, call.args[i]};
    left = ast.make<CallExpr>(call.nameRange, call.range, call.name, ast.copy<Expr *>(pair));
  }
  Expr *pair[] = {left, call.args.back()};
  return ast.make<CallExpr>(call.nameRange, call.range, call.name, ast.copy<Expr *>(pair));
}

/// A function of floats is applied to triples component by component, as sqrt(Cs) or pow(Cs, 2).
bool Sema::chooseComponentWise(CallExpr &call, ArrayRef<Type> args) {
  TypeKind kind = TypeKind::Error;
  for (Type arg : args) {
    if (arg.isTriple() && kind == TypeKind::Error)
      kind = arg.kind;
    else if (!arg.is(TypeKind::Float) && arg.kind != kind)
      return false;
  }
  if (kind == TypeKind::Error)
    return false;
  for (const Builtin *builtin : builtinsNamed(call.name)) {
    bool fits = builtin->result == TypeKind::Float && builtin->operands.size() == args.size();
    for (const BuiltinOperand &operand : builtin->operands)
      fits &= operand.source == BuiltinOperand::In && operand.type == TypeKind::Float;
    if (!fits)
      continue;
    call.builtin = builtin;
    call.form = CallForm::ComponentWise;
    bool varying = false, bad = false;
    for (size_t i = 0; i < args.size(); ++i) {
      call.args[i] = check(call.args[i], args[i].kind);
      varying |= call.args[i]->type.varying;
      bad |= call.args[i]->type.isError();
      call.hasEffects |= call.args[i]->hasEffects;
    }
    call.type = {bad ? TypeKind::Error : kind, varying};
    return true;
  }
  return false;
}

Expr *Sema::checkCall(CallExpr &given, TypeKind hint) {
  if (given.object && !isThis(given.object)) {
    given.object = check(given.object);
    if (given.object->type.is(TypeKind::Shader))
      return checkRemoteCall(given, hint);
    if (!given.object->type.isStruct())
      return reportNoObject(given);
  }
  std::vector<Candidate> all = candidates(given);
  if (all.empty() && !given.object)
    if (StructDecl *structure = lookupStruct(given.name))
      return checkConstructor(given, *structure);
  if (all.empty() && !given.object)
    if (Expr *special = checkSpecial(given, hint))
      return special;
  if (!all.empty() && all[0].builtin)
    if (Expr *rewritten = rewriteCall(given, hint))
      return rewritten;
  CallExpr *call = &given;
  splitNamed(given);
  bool isExtreme = given.name == "min" || given.name == "max";
  if (isExtreme && given.args.size() > 2 && !all.empty() && all[0].builtin) {
    call = foldExtremes(given);
    call->depth = given.depth;
  }
  SmallVector<Type, 8> args;
  bool bad = false;
  for (Expr *arg : call->args)
    args.push_back(probe(arg));
  std::optional<Candidate> chosen = choose(*call, args, hint);
  if (!chosen && !call->object && chooseComponentWise(*call, args))
    return call;
  if (!chosen && all.empty() && !call->object && !missingFor(call->name).empty()) {
    // Its arguments may have forms of their own, such as "file"[channel].
    reportUnknown(*call);
    call->type = {TypeKind::Error};
    return call;
  }
  if (!chosen) {
    for (Expr *&arg : call->args) {
      arg = check(arg);
      bad |= arg->type.isError();
    }
    // Where an argument is wrong by itself, that message is enough.
    if (all.empty())
      reportUnknown(*call);
    else if (!bad)
      reportNoMatch(*call, args, all);
    for (Expr *&value : call->rest)
      value = check(value);
    call->type = {TypeKind::Error};
    return call;
  }
  call->function = chosen->function;
  call->builtin = chosen->builtin;
  call->form = call->function ? CallForm::Function : CallForm::Builtin;
  if (call->function) {
    call->function->isUsed = true;
    if (call->function->parent && call->function->parent == structure)
      checkMethod(*call->function);
  }
  if (call->function && call->function->isBeingChecked) {
    diags.error(call->loc, "function '" + call->name + "' calls itself; RSL has no recursion")
        .range(call->nameRange)
        .note(call->function->range.Start, "declared here", call->function->range);
    bad = true;
  }

  bool varying = false;
  for (size_t i = 0; i < call->args.size(); ++i) {
    Type param = chosen->type(i);
    std::string what = ("argument " + Twine(i + 1) + " of '" + call->name + "'").str();
    Expr *&arg = call->args[i];
    if (chosen->isOut(i)) {
      // A variable that is only written by the call is not read by it.
      auto *name = dyn_cast<NameExpr>(arg);
      VarDecl *decl = name ? lookup(name->name) : nullptr;
      bool wasRead = decl && decl->isRead;
      arg = check(arg);
      if (decl && !chosen->isIn(i))
        decl->isRead = wasRead;
      call->hasEffects = true;
    } else if (auto *list = dyn_cast<ListExpr>(arg); list && param.isArray()) {
      param.length = static_cast<int>(list->elements.size());
      arg = checkList(*list, param);
    } else {
      arg = checkAs(arg, param, what);
    }
    if (chosen->isIn(i))
      varying |= arg->type.varying;
    if (chosen->builtin && chosen->builtin->op == stc::Op::ctransform && param.is(TypeKind::String))
      checkColorSpace(*arg);
    bad |= arg->type.isError();
    call->hasEffects |= arg->hasEffects;
    if (chosen->function && chosen->function->params[i]->hasStorage && chosen->isIn(i))
      checkStorage(arg, param.varying, what + " is uniform");
  }
  if (chosen->builtin && chosen->builtin->named) {
    checkNamed(*call, *chosen->builtin->named, varying, bad);
  } else {
    for (Expr *&value : call->rest) {
      // directlighting(this, …), which looks at no argument here.
      if (isThis(value) && structure && structure->isClass)
        value = ast.make<NameExpr>(value->range, "null");
      value = check(value);
      bad |= value->type.isError();
      call->hasEffects |= value->hasEffects;
    }
  }
  SmallVector<Expr *, 4> steps;
  if (chosen->function && !bad) {
    flattenArguments(*call, steps);
    if (call->object && !isThis(call->object)) {
      bindObject(*call, steps);
      if (function && structure && structure->isClass)
        function->assignsMembers = true;
      call->hasEffects = true;
    }
  }
  if (chosen->function && !bad)
    checkResizedArguments(*call);
  if (chosen->function) {
    varying |= chosen->function->isVarying;
    if (chosen->function->resultHasStorage)
      varying = chosen->function->result.varying;
    call->hasEffects |= chosen->function->usesOuter;
    if (chosen->function->isVarying)
      useVarying();
    if (function)
      function->assignsMembers |= chosen->function->assignsMembers;
  } else {
    for (const BuiltinOperand &operand : chosen->builtin->operands)
      if (operand.source == BuiltinOperand::Global) {
        varying |= stc::globalNumbered(unsigned(operand.global))->storage == stc::Storage::Varying;
        if (function)
          function->usesOuter = true;
      }
    const stc::OpInfo &op = stc::info(chosen->builtin->op);
    if (op.rule == stc::Rule::Uniform)
      varying = false;
    // random() gives one number for all points where that is what is asked for.
    if (op.rule == stc::Rule::Varying && op.effect != stc::Effect::Random)
      varying = true;
    call->hasEffects |= op.purity == stc::Purity::Stateful;
    if (varying && op.rule == stc::Rule::Varying)
      useVarying();
    for (const BuiltinOperand &operand : chosen->builtin->operands)
      if (operand.source == BuiltinOperand::Light && !illuminances && !function)
        diags.error(call->loc, "'" + call->name + "' exists only inside of 'illuminance'")
            .range(call->nameRange);
  }
  for (size_t i = 0; i < call->args.size() && !bad; ++i) {
    const VarDecl *param = chosen->function ? chosen->function->leaves[i] : nullptr;
    if (param ? param->isOutput : chosen->isOut(i)) {
      bool argVaries = varying;
      if (param && param->hasStorage)
        argVaries = param->type.varying;
      checkTarget(call->args[i], argVaries, call->args[i]->loc,
                  ("output argument " + Twine(i + 1) + " of '" + call->name + "'").str());
    }
  }
  call->type = {bad ? TypeKind::Error : chosen->result(), varying};
  if (bad || !chosen->function)
    return call;
  if (chosen->function->resultVariable)
    return copyResult(*call, steps);
  return sequence(steps, call, call->range);
}

/// A method is called on something that has none.
Expr *Sema::reportNoObject(CallExpr &call) {
  for (Expr *&arg : call.args)
    arg = check(arg);
  if (!call.object->type.isError())
    diags.error(call.loc, "a value of type '" + toString(call.object->type) + "' has no methods")
        .range(call.object->range);
  call.type = {TypeKind::Error};
  return &call;
}

StructDecl *Sema::lookupStruct(StringRef name) {
  for (Scope &scope : llvm::reverse(scopes))
    if (StructDecl *found = scope.structs.lookup(name))
      return found;
  return nullptr;
}

//===-- Messages --------------------------------------------------------------------------------//

void Sema::reportUnknown(const CallExpr &call) {
  if (call.object) {
    const StructDecl *owner = isThis(call.object) ? structure : call.object->type.structure;
    std::vector<StringRef> names;
    if (owner)
      for (const FunctionDecl *method : owner->methods)
        names.push_back(method->name);
    auto error = diags.error(call.loc, owner ? ("'" + owner->name + "' has no method '" +
                                                call.name + "'" + didYouMean(call.name, names))
                                                   .str()
                                             : "'this' exists only in methods");
    error.range(call.nameRange);
    if (owner)
      error.note(owner->range.Start, "declared here", owner->range);
    return;
  }
  if (StringRef need = missingFor(call.name); !need.empty()) {
    diags.error(call.loc, "built-in '" + call.name + "' is not supported: it needs " + need)
        .range(call.nameRange);
    return;
  }
  std::vector<StringRef> names;
  for (const Scope &scope : scopes)
    for (const auto &entry : scope.functions)
      names.push_back(entry.first());
  llvm::sort(names);
  llvm::append_range(names, builtinNames());
  auto error =
      diags.error(call.loc, "unknown function '" + call.name + "'" + didYouMean(call.name, names));
  error.range(call.nameRange);
  if (std::optional<StringRef> likely = suggest(call.name, names))
    error.fixit(call.nameRange, *likely);
  for (FunctionDecl *decl : ast.functions)
    if (decl->name == call.name) {
      error.note(decl->range.Start, "it is defined later; functions must stand before their use",
                 decl->range);
      break;
    }
}

void Sema::reportNoMatch(const CallExpr &call, ArrayRef<Type> args,
                         ArrayRef<Candidate> candidates) {
  std::string types;
  for (size_t i = 0; i < args.size(); ++i)
    types += (i ? ", " : "") + toString(call.args[i]->type);
  auto error = diags.error(call.loc, "no function '" + call.name + "' takes (" + types + ")");
  error.range(call.nameRange);
  for (const Expr *arg : call.args)
    error.range(arg->range);
  // Overloads with as many arguments are the likelier ones; a long list helps nobody.
  static constexpr unsigned MaxNotes = 6;
  bool someFit = llvm::any_of(
      candidates, [&](const Candidate &candidate) { return candidate.size() == args.size(); });
  unsigned notes = 0, left = 0;
  for (const Candidate &candidate : candidates) {
    if (someFit && candidate.size() != args.size())
      continue;
    if (++notes > MaxNotes) {
      ++left;
      continue;
    }
    std::string text = "candidate: " + signature(candidate);
    if (candidate.size() != args.size()) {
      text += ", which takes " + utostr(candidate.size()) + " argument" +
              (candidate.size() == 1 ? "" : "s");
    } else {
      for (size_t i = 0; i < args.size(); ++i)
        if (argumentCost(candidate, i, call.args[i]->type) < 0) {
          text += ", whose argument " + utostr(i + 1) + " is no " + toString(call.args[i]->type);
          break;
        }
    }
    if (candidate.function)
      error.note(candidate.function->range.Start, text, candidate.function->range);
    else
      error.note(call.loc, text, {}, /*showsLine=*/false);
  }
  if (left)
    error.note(call.loc, "and " + Twine(left) + " more", {}, /*showsLine=*/false);
}

} // namespace anysl::rsl
