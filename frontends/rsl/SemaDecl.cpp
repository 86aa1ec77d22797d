//===-- frontends/rsl/SemaDecl.cpp - declarations and scopes ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "lib/STC/Shader.h"

using namespace llvm;

namespace anysl::rsl {

Sema::Sema(Ast &ast, DiagnosticEngine &diags, Options options)
    : ast(ast), diags(diags), options(options) {}

void Sema::check() {
  scopes.emplace_back();
  declareGlobals();
  ast.shaders.clear(); // they come back in order, those that classes are among them
  for (auto [i, item] : enumerate(ast.items)) {
    if (diags.reachedLimit())
      return;
    if (i == ast.firstOwnItem)
      scopes.emplace_back();
    if (item.function)
      checkFunction(*item.function);
    else if (item.structure && item.structure->isClass)
      checkClass(*item.structure);
    else if (item.structure)
      checkStruct(*item.structure);
    else
      checkShader(*item.shader);
  }
  if (options.isLibrary) {
    for (ShaderDecl *decl : ast.shaders)
      diags.error(decl->range.Start, "a library contains functions only").range(decl->range);
    return;
  }
  // Headers define more than a shader uses; only the main file's own functions are worth a word.
  for (FunctionDecl *decl : ast.functions)
    if (!decl->isUsed && !ast.shaders.empty() &&
        diags.sources().FindBufferContainingLoc(decl->range.Start) ==
            diags.sources().getMainFileID())
      diags.warning(decl->range.Start, warn::UnusedFunction, "unused function '" + decl->name + "'")
          .range(decl->range);
}

//===-- Scopes ----------------------------------------------------------------------------------//

void Sema::declareGlobals() {
  static constexpr StringLiteral readOnly[] = {"Ng", "I",    "E",    "u",  "v",      "du",
                                               "dv", "dPdu", "dPdv", "Ps", "ncomps", "time"};
  for (const stc::GlobalVariableInfo &global : stc::allGlobals()) {
    if (global.isHidden)
      continue;
    auto *decl = ast.make<VarDecl>();
    decl->kind = VarKind::Global;
    decl->name = global.name;
    decl->type = {typeKindOf(global.type), global.storage == stc::Storage::Varying, Type::NoArray};
    decl->id = global.id;
    decl->isReadOnly = llvm::is_contained(readOnly, decl->name);
    scopes.back().variables[global.name] = decl;
  }
}

void Sema::pushScope() {
  scopes.emplace_back();
  scopes.back().function = function;
}

void Sema::popScope() {
  // In the order of the text, not of the hash table.
  std::vector<const VarDecl *> decls;
  for (const auto &entry : scopes.back().variables)
    decls.push_back(entry.second);
  llvm::sort(decls, [](const VarDecl *a, const VarDecl *b) {
    return a->range.Start.getPointer() < b->range.Start.getPointer();
  });
  for (const VarDecl *decl : decls)
    warnUnused(*decl);
  scopes.pop_back();
}

void Sema::warnUnused(const VarDecl &decl) {
  if (decl.kind != VarKind::Local || decl.isRead || decl.type.isError())
    return;
  if (decl.isAssigned)
    diags
        .warning(decl.range.Start, warn::UnusedButSet,
                 "variable '" + decl.name + "' is set but never read")
        .range(decl.range);
  else
    diags.warning(decl.range.Start, warn::UnusedVariable, "unused variable '" + decl.name + "'")
        .range(decl.range);
}

void Sema::declare(VarDecl *decl) {
  decl->branches = varyingConditions.size();
  auto [entry, isNew] = scopes.back().variables.try_emplace(decl->name, decl);
  if (!isNew && entry->second->kind != VarKind::Global) {
    diags.error(decl->range.Start, "redefinition of '" + decl->name + "'")
        .range(decl->range)
        .note(entry->second->range.Start, "previously declared here", entry->second->range);
    return;
  }
  entry->second = decl;
  for (const Scope &scope : ArrayRef(scopes).drop_back())
    if (auto outer = scope.variables.find(decl->name);
        outer != scope.variables.end() && outer->second->kind != VarKind::Global &&
        decl->kind == VarKind::Local && scope.function == function)
      diags
          .warning(decl->range.Start, warn::Shadow,
                   "'" + decl->name + "' hides another variable of this name")
          .range(decl->range)
          .note(outer->second->range.Start, "the hidden variable", outer->second->range);
}

/// The variable that a name means here, or null. `owner` is the function whose scope it is in.
VarDecl *Sema::lookup(StringRef name, FunctionDecl **owner) {
  for (Scope &scope : llvm::reverse(scopes)) {
    auto found = scope.variables.find(name);
    if (found == scope.variables.end())
      continue;
    if (owner)
      *owner = scope.function;
    return found->second;
  }
  return nullptr;
}

/// Once an unknown name is reported, its further uses are not.
void Sema::declareUnknown(StringRef name, SMRange range) {
  auto *unknown = ast.make<VarDecl>();
  unknown->kind = VarKind::Local;
  unknown->name = name;
  unknown->range = range;
  unknown->isRead = true;
  scopes.back().variables[name] = unknown;
}

std::vector<StringRef> Sema::visibleNames() const {
  std::vector<StringRef> names;
  for (const Scope &scope : llvm::reverse(scopes))
    for (const auto &entry : scope.variables)
      if (!entry.second->type.isError()) // one that was reported itself
        names.push_back(entry.first());
  names.push_back("PI");
  // The order of a hash table must not decide what is suggested.
  llvm::sort(names);
  return names;
}

//===-- Shaders and functions -------------------------------------------------------------------//

/// A shader's name and kind together are its own; the shaders that a class is share its name.
void Sema::checkShaderName(const ShaderDecl &decl) {
  for (ShaderDecl *other : ast.shaders)
    if (other->name == decl.name && other->range.Start != decl.range.Start) {
      diags.error(decl.range.Start, "redefinition of shader '" + decl.name + "'")
          .range(decl.range)
          .note(other->range.Start, "previously defined here", other->range);
      return;
    }
}

void Sema::checkShader(ShaderDecl &decl) {
  checkShaderName(decl);
  ast.shaders.push_back(&decl);
  shader = &decl;
  pushScope();
  checkParams(decl.params);
  pushScope();
  for (Stmt *stmt : decl.body->body)
    checkStmt(stmt);
  popScope();
  popScope();
  shader = nullptr;
}

void Sema::checkParam(VarDecl &param) {
  checkArrayLength(param);
  if (param.type.structure) {
    diags.error(param.range.Start, "a shader's parameter cannot be a structure").range(param.range);
    param.type = {};
    param.init = nullptr;
    return declare(&param);
  }
  // The host may give an array without a length or elements as many as there is room for.
  auto *list = dyn_cast_or_null<ListExpr>(param.init);
  if (param.type.length == Type::AnyLength && (!param.init || (list && list->elements.empty()))) {
    param.type.isResizable = true;
    param.type.length = options.arrayCapacity;
  }
  if (!param.init) {
    diags
        .warning(param.range.Start, warn::MissingDefault,
                 "parameter '" + param.name + "' has no default; it is taken to be " +
                     (param.type.isResizable                ? "empty"
                      : param.type.kind == TypeKind::String ? "\"\""
                                                            : "0"))
        .range(param.range);
  } else {
    checkInitialiser(param);
    param.defaultVaries = param.init->type.varying;
    if (param.type.varying && param.type.kind == TypeKind::String) {
      diags.error(param.range.Start, "a string parameter cannot be varying").range(param.range);
      param.type.varying = false;
    }
  }
  if (param.type.isArray() && param.type.length == Type::AnyLength && !param.type.isError()) {
    diags.error(param.range.Start, "array parameter '" + param.name + "' needs a length")
        .range(param.range);
    param.type.length = 1;
  }
  declare(&param);
}

void Sema::checkFunction(FunctionDecl &decl) {
  if (options.isLibrary && !decl.outer)
    matchLibraryFunction(decl);
  declareFunction(decl);
  checkBody(decl);
  for (FunctionDecl *form : decl.shorter)
    checkFunction(*form);
}

/// Makes a function known where it stands.
void Sema::declareFunction(FunctionDecl &decl) {
  checkArrayResult(decl);
  SmallVector<FunctionDecl *, 2> &overloads = scopes.back().functions[decl.name];
  for (FunctionDecl *&other : overloads) {
    bool same = other->result.kind == decl.result.kind &&
                other->result.isArray() == decl.result.isArray() &&
                other->params.size() == decl.params.size();
    for (size_t i = 0; same && i < decl.params.size(); ++i)
      same = other->params[i]->type.kind == decl.params[i]->type.kind &&
             other->params[i]->type.structure == decl.params[i]->type.structure &&
             other->params[i]->type.isArray() == decl.params[i]->type.isArray();
    if (!same)
      continue;
    // Headers of other renderers have helpers in common.
    diags
        .warning(decl.range.Start, warn::FunctionRedefined,
                 "redefinition of function '" + decl.name + "'; this one counts from here on")
        .range(decl.range)
        .note(other->range.Start, "previously defined here", other->range);
    other = &decl;
    return;
  }
  overloads.push_back(&decl);
}

void Sema::checkBody(FunctionDecl &decl) {
  FunctionDecl *outerFunction = std::exchange(function, &decl);
  unsigned outerLoops = std::exchange(loops, 0);
  unsigned outerIlluminances = std::exchange(illuminances, 0);
  decl.isBeingChecked = true;
  pushScope();
  for (VarDecl *param : decl.params) {
    checkArrayLength(*param);
    if (param->type.structure)
      expandStruct(*param);
    declare(param);
  }
  SmallVector<VarDecl *, 16> leaves;
  appendLeaves(decl.params, leaves);
  decl.leaves = ast.copy<VarDecl *>(leaves);
  if (decl.result.structure || decl.result.isArray()) {
    bool isUniform = decl.resultHasStorage && !decl.result.varying;
    Type result = decl.result.withVarying(decl.result.structure || !isUniform);
    result.length = result.isResizable ? 1 : result.length;
    decl.resultVariable = hiddenVariable(result, decl.range)->decl;
  }
  pushScope();
  for (Stmt *stmt : decl.body->body)
    checkStmt(stmt);
  popScope();
  popScope();
  if (decl.result.kind != TypeKind::Void && !alwaysReturns(decl.body)) {
    auto warning = diags.warning(decl.body->end, warn::ReturnType,
                                 "function '" + decl.name +
                                     "' may end without returning a value; it is then 0");
    warning.note(decl.range.Start, "declared here", decl.range);
    if (decl.result.kind == TypeKind::Shader)
      warning.note(decl.range.Start,
                   "this is a function that gives a handle; a shader is declared by its kind: "
                   "surface, displacement, light, volume or imager",
                   decl.range);
  }
  decl.isBeingChecked = false;
  decl.isChecked = true;
  function = outerFunction;
  loops = outerLoops;
  illuminances = outerIlluminances;
  // What the inner function sees of the outside, the outer one's value depends on.
  if (function && decl.isVarying)
    function->isVarying = true;
}

/// Finds the built-in that a library's function implements: name, result and arguments must agree,
/// where points, vectors and normals count as one.
void Sema::matchLibraryFunction(FunctionDecl &decl) {
  ArrayRef<const Builtin *> overloads = builtinsNamed(decl.name);
  if (overloads.empty())
    return;
  auto agree = [](TypeKind a, TypeKind b) {
    return a == b || (Type{a}.isGeometric() && Type{b}.isGeometric());
  };
  for (const Builtin *builtin : overloads) {
    size_t fields = builtin->named ? builtin->named->fields.size() : 0;
    bool same = agree(builtin->result, decl.result.kind) && !decl.result.isArray() &&
                builtin->arguments.size() + fields == decl.params.size();
    for (size_t i = 0; same && i < builtin->arguments.size(); ++i)
      same = agree(builtin->arguments[i].type, decl.params[i]->type.kind) &&
             builtin->arguments[i].isOut == decl.params[i]->isOutput &&
             !decl.params[i]->type.isArray() && !decl.params[i]->length;
    for (size_t i = 0; same && i < fields; ++i) {
      const VarDecl &param = *decl.params[builtin->arguments.size() + i];
      same = agree(builtin->named->fields[i].type, param.type.kind) && !param.isOutput &&
             !param.type.isArray();
    }
    // Overloads that only fill in operands (fresnel with five arguments) are not operators
    // themselves.
    for (const BuiltinOperand &operand : builtin->operands)
      same &= operand.source <= BuiltinOperand::Global || operand.source == BuiltinOperand::Named;
    if (!same)
      continue;
    decl.defines = builtin;
    decl.isUsed = true;
    for (FunctionDecl *other : ast.functions) {
      if (other == &decl)
        break;
      if (other->defines && other->defines->op == builtin->op)
        diags
            .error(decl.range.Start,
                   "operator '" + stc::info(builtin->op).name + "' is defined twice")
            .range(decl.range)
            .note(other->range.Start, "first defined here", other->range);
    }
    return;
  }
  auto error = diags.error(decl.range.Start, "no built-in '" + decl.name + "' has this signature");
  error.range(decl.range);
  for (const Builtin *builtin : overloads)
    error.note(decl.range.Start, "candidate: " + rsl::signature(*builtin), {},
               /*showsLine=*/false);
}

//===-- Variables -------------------------------------------------------------------------------//

void Sema::checkArrayLength(VarDecl &decl) {
  if (!decl.length)
    return;
  decl.length = check(decl.length, TypeKind::Float);
  if (decl.length->type.isError()) {
    decl.type.length = 1;
    return;
  }
  if (!constant(decl.length) && decl.kind == VarKind::Local && !decl.type.structure &&
      decl.length->type.is(TypeKind::Float)) {
    decl.type.isResizable = true; // as if resize() came next
    decl.type.length = 64;
  } else {
    decl.type.length = arrayLength(decl.length);
  }
}

/// The constant that a checked expression for an array's length is; 1 after an error.
int Sema::arrayLength(Expr *length) {
  std::optional<double> value = constant(length);
  if (value && *value >= 1 && *value <= stc::maxArrayLength && *value == static_cast<int>(*value))
    return static_cast<int>(*value);
  if (length->type.isError())
    return 1;
  diags
      .error(length->loc, value ? "the length of an array must be an integer from 1 to " +
                                      Twine(stc::maxArrayLength)
                                : Twine("the length of an array must be a constant number"))
      .range(length->range);
  return 1;
}

void Sema::checkVariable(VarDecl &decl) {
  checkArrayLength(decl);
  if (decl.type.structure) {
    if (decl.type.length == Type::AnyLength)
      if (auto *list = dyn_cast_or_null<ListExpr>(decl.init); list && !list->elements.empty())
        decl.type.length = static_cast<int>(list->elements.size());
    expandStruct(decl);
    if (decl.init)
      initialiseStruct(decl);
  } else if (decl.init || decl.type.length == Type::AnyLength) {
    if (decl.type.length == Type::AnyLength) {
      decl.type.isResizable = true;
      auto *list = dyn_cast_or_null<ListExpr>(decl.init);
      decl.type.length = list ? std::max<int>(1, int(list->elements.size())) : 1;
    }
    // The value is looked at before the name is there: `float s = s` means the outer s.
    if (decl.init)
      checkInitialiser(decl);
  }
  if (decl.type.length == Type::AnyLength) {
    diags.error(decl.range.Start, "array '" + decl.name + "' of structures needs a length")
        .range(decl.range);
    decl.type.length = 1;
  }
  declare(&decl);
}

void Sema::checkInitialiser(VarDecl &decl) {
  std::string what = ("initialising '" + decl.name + "'").str();
  if (decl.type.isArray()) {
    auto *list = dyn_cast<ListExpr>(decl.init);
    if (!list) {
      decl.init = checkWhole(decl.init, decl.type, what);
      if (decl.type.length == Type::AnyLength && decl.init->type.isArray())
        decl.type.length = decl.init->type.length;
      if (decl.type.isResizable && decl.init->type.isArray())
        decl.type.length = std::max(decl.type.length, decl.init->type.length);
    } else {
      if (decl.type.length == Type::AnyLength && !list->elements.empty())
        decl.type.length = static_cast<int>(list->elements.size());
      decl.init = checkList(*list, decl.type);
    }
  } else {
    decl.init = checkAs(decl.init, decl.type, what);
  }
  checkStorage(decl.init, decl.type.varying, what + " of uniform type");
}

void Sema::checkExtern(ExternStmt &stmt) {
  for (VarDecl *written : stmt.variables) {
    if (written->init)
      diags.error(written->init->loc, "an extern variable cannot be initialised here")
          .range(written->init->range);
    // The name is looked for outside of the function that the declaration stands in.
    VarDecl *found = nullptr;
    for (Scope &scope : llvm::reverse(scopes)) {
      if (scope.function == function && function)
        continue;
      if (auto entry = scope.variables.find(written->name); entry != scope.variables.end()) {
        found = entry->second;
        break;
      }
    }
    if (!found) {
      diags
          .error(written->range.Start, "no '" + written->name + "' outside of this function" +
                                           didYouMean(written->name, visibleNames()))
          .range(written->range);
      declareUnknown(written->name, written->range);
      continue;
    }
    if (found->type.kind != written->type.kind) {
      auto error = diags.error(written->range.Start, "'" + written->name + "' is of type '" +
                                                         toString(found->type) + "', not '" +
                                                         toString(written->type) + "'");
      error.range(written->range);
      if (found->range.isValid())
        error.note(found->range.Start, "declared here", found->range);
    }
    if (found->type.varying)
      useVarying();
    if (function)
      function->usesOuter = true;
    scopes.back().variables[written->name] = found;
  }
}

} // namespace anysl::rsl
