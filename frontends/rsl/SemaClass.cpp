//===-- frontends/rsl/SemaClass.cpp - class shaders -------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A class shader is a structure whose members belong to the shader and whose entry methods make it
// one shader of each kind. Each of these is written as if it were an ordinary one:
//
//   surface name(params) { members; construct(); begin(); opacity(Oi); surface(Ci, Oi); }
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "lib/STC/Shader.h"

using namespace llvm;

namespace anysl::rsl {

namespace {
/// A method that the renderer calls, and the globals that are its arguments.
struct Entry {
  StringLiteral name;
  ShaderType type;
  std::initializer_list<StringLiteral> globals;
};
} // namespace

/// In the order in which those of one kind run.
static ArrayRef<Entry> entries() {
  static const Entry table[] = {
      {"opacity", ShaderType::Surface, {"Oi"}},
      {"surface", ShaderType::Surface, {"Ci", "Oi"}},
      {"prelighting", ShaderType::Surface, {"Ci", "Oi"}},
      {"lighting", ShaderType::Surface, {"Ci", "Oi"}},
      {"postlighting", ShaderType::Surface, {"Ci", "Oi"}},
      {"displacement", ShaderType::Displacement, {"P", "N"}},
      {"light", ShaderType::Light, {"L", "Cl"}},
      {"volume", ShaderType::Volume, {"Ci", "Oi"}},
      {"imager", ShaderType::Imager, {"Ci", "Oi"}},
  };
  return table;
}

void Sema::checkClass(StructDecl &decl) {
  pushScope();
  checkParams(decl.params);
  checkMembers(decl);
  popScope();
}

/// The method of a name that takes as many arguments as possible, of so many; where all take more,
/// the first; null if there is none.
static FunctionDecl *methodNamed(const StructDecl &decl, StringRef name, size_t arguments) {
  FunctionDecl *found = nullptr;
  auto fits = [&](const FunctionDecl &method) { return method.params.size() <= arguments; };
  for (FunctionDecl *method : decl.methods)
    if (method->name == name &&
        (!found ||
         (fits(*method) && (!fits(*found) || method->params.size() > found->params.size()))))
      found = method;
  return found;
}

/// Whether a method can be called with these globals; an error if not.
bool Sema::checkEntry(const FunctionDecl &method, ArrayRef<StringLiteral> globals) {
  std::string wanted;
  bool fits = method.params.size() <= globals.size() && method.result.kind == TypeKind::Void;
  for (size_t i = 0; i < globals.size(); ++i) {
    VarDecl *global = scopes.front().variables.lookup(globals[i]);
    wanted += (i ? ", " : "") + ("output " + toString(global->type) + " " + globals[i]).str();
    fits &= i >= method.params.size() ||
            (method.params[i]->type.is(global->type.kind) && method.params[i]->isOutput);
  }
  if (!fits)
    diags
        .error(method.range.Start,
               "method '" + method.name + "' must be void " + method.name + "(" + wanted + ")")
        .range(method.range);
  return fits;
}

Stmt *Sema::callOf(FunctionDecl &method, ArrayRef<Expr *> args) {
  auto *call = ast.make<CallExpr>(method.range, method.range, method.name, ast.copy<Expr *>(args));
  call->function = &method;
  call->hasEffects = true;
  call->type = {TypeKind::Void};
  return ast.make<ExpressionStmt>(call);
}

/// The shaders that a class is; its methods are checked.
void Sema::makeEntries(StructDecl &decl) {
  SmallVector<Stmt *, 8> begin;
  begin.push_back(ast.make<DeclarationStmt>(decl.range.Start, decl.members));
  for (StringRef name : {"construct", "begin"})
    if (FunctionDecl *method = methodNamed(decl, name, 0); method && checkEntry(*method, {}))
      begin.push_back(callOf(*method, {}));
  bool any = false;
  for (ShaderType type : {ShaderType::Surface, ShaderType::Displacement, ShaderType::Light,
                          ShaderType::Volume, ShaderType::Imager}) {
    SmallVector<Stmt *, 8> body = begin;
    bool isShader = false;
    if (type == ShaderType::Surface)
      if (FunctionDecl *method = methodNamed(decl, "displacement", 2))
        body.push_back(displacementForMembers(*method));
    for (const Entry &entry : entries()) {
      FunctionDecl *method =
          entry.type == type ? methodNamed(decl, entry.name, entry.globals.size()) : nullptr;
      // With a method for the whole the phases are not called.
      bool isPhase = entry.name.ends_with("lighting");
      if (!method || (isPhase && methodNamed(decl, "surface", 2)))
        continue;
      isShader = true;
      if (!checkEntry(*method, entry.globals))
        continue;
      SmallVector<Expr *, 2> args;
      for (StringRef name : ArrayRef(entry.globals.begin(), method->params.size()))
        args.push_back(reference(*scopes.front().variables.lookup(name), method->range));
      body.push_back(callOf(*method, args));
    }
    if (!isShader)
      continue;
    any = true;
    auto *shader = ast.make<ShaderDecl>();
    shader->type = type;
    shader->name = decl.name;
    shader->range = decl.range;
    shader->params = decl.params;
    shader->body = ast.make<BlockStmt>(decl.range.Start, decl.range.End, ast.copy<Stmt *>(body));
    checkShaderName(*shader);
    ast.shaders.push_back(shader);
  }
  size_t before = ast.shaders.size();
  makeMethods(decl, begin);
  if (!any && ast.shaders.size() == before)
    diags
        .warning(decl.range.Start, warn::Uncallable,
                 "class '" + decl.name +
                     "' has no method that a renderer or another shader can call")
        .range(decl.range);
}

/// Members that displacement() sets are there in surface(), which is another shader: it runs on
/// copies of the position and normal, which may have been moved already.
Stmt *Sema::displacementForMembers(FunctionDecl &method) {
  if (!method.assignsMembers || !checkEntry(method, {"P", "N"}))
    return ast.make<Stmt>(StmtKind::Empty, method.range.Start);
  SmallVector<Stmt *, 3> steps;
  SmallVector<Expr *, 2> args;
  for (const VarDecl *param : method.params) {
    auto *copy = ast.make<VarDecl>();
    copy->kind = VarKind::Local;
    copy->name = param->name;
    copy->range = method.range;
    copy->type = param->type.withVarying(true);
    copy->init =
        reference(*scopes.front().variables.lookup(args.empty() ? "P" : "N"), method.range);
    args.push_back(reference(*copy, method.range));
    steps.push_back(ast.make<DeclarationStmt>(method.range.Start, ast.copy<VarDecl *>(copy)));
  }
  steps.push_back(callOf(method, args));
  return ast.make<BlockStmt>(method.range.Start, method.range.End, ast.copy<Stmt *>(steps));
}

} // namespace anysl::rsl
