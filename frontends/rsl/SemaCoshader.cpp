//===-- frontends/rsl/SemaCoshader.cpp - shaders that call each other -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A handle names another shader, of a class that this file knows nothing about. So a call hands
// over numbers, and says by letters what they are: `bump(tf)f` is a method of a triple and a float
// that gives a float. A public method is a shader of its own under that name, which unpacks them:
//
//   method `wood.bump(tf)f`(params; output matrix arguments[2]) {
//     members; construct(); begin();
//     vector a0 = vector(comp(arguments[0], 0, 0), …); float a1 = …;
//     setcomp(arguments[0], 0, 0, bump(a0, a1));
//   }
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

static constexpr unsigned MatrixSize = 16;

static std::optional<CoshaderOp> coshaderOp(StringRef name) {
  return StringSwitch<std::optional<CoshaderOp>>(name)
      .Case("getshader", CoshaderOp::Get)
      .Case("getshaders", CoshaderOp::GetAll)
      .Case("getlights", CoshaderOp::GetLights)
      .Case("getvar", CoshaderOp::Variable)
      .Default(std::nullopt);
}

bool isCoshaderCall(StringRef name) { return coshaderOp(name).has_value(); }

/// The letter of a type in a method's name; 0 if values of it cannot be handed over.
static char letter(Type type) {
  return type.is(TypeKind::Float)    ? 'f'
         : type.isTriple()           ? 't'
         : type.is(TypeKind::Matrix) ? 'm'
         : type.is(TypeKind::Void)   ? 'v'
                                     : 0;
}

unsigned componentsOf(Type type) {
  return type.is(TypeKind::Float) ? 1 : type.isTriple() ? 3 : type.is(TypeKind::Matrix) ? 16 : 0;
}

//===-- Calls -----------------------------------------------------------------------------------//

static Expr *failed(Expr *expr) {
  expr->type = {TypeKind::Error};
  return expr;
}

/// getshader(name), getshaders(["category", c]), getlights(…), getvar(shader, name, variable)
Expr *Sema::checkCoshaderCall(CallExpr &call) {
  call.form = CallForm::Coshader;
  call.coshaderOp = *coshaderOp(call.name);
  call.type = {TypeKind::Error};
  auto wrong = [&](StringRef takes) {
    diags.error(call.loc, "'" + call.name + "' takes " + takes).range(call.nameRange);
    return failed(&call);
  };
  bool bad = false;
  for (size_t i = 0; i < call.args.size(); ++i) {
    bool isHandle = call.coshaderOp == CoshaderOp::Variable && i == 0;
    bool isVariable = call.coshaderOp == CoshaderOp::Variable && i == 2;
    Type wanted{isHandle ? TypeKind::Shader : TypeKind::String, true};
    call.args[i] = isVariable
                       ? check(call.args[i])
                       : checkAs(call.args[i], wanted,
                                 ("argument " + Twine(i + 1) + " of '" + call.name + "'").str());
    bad |= call.args[i]->type.isError();
    call.hasEffects |= call.args[i]->hasEffects;
  }
  if (bad)
    return &call;
  switch (call.coshaderOp) {
  case CoshaderOp::Get:
    if (call.args.size() != 1)
      return wrong("the name of a shader");
    call.type = {TypeKind::Shader, call.args[0]->type.varying};
    return &call;
  case CoshaderOp::GetLights:
    diags.warning(call.loc, warn::Unanswered, "lights have no handles here: 'getlights' gives none")
        .range(call.nameRange);
    [[fallthrough]];
  case CoshaderOp::GetAll:
    if (call.args.size() != 0 && call.args.size() != 2)
      return wrong("nothing, or \"category\" and its name");
    call.type = {TypeKind::Shader, false, CoshaderLimit, nullptr, true};
    return &call;
  case CoshaderOp::Variable:
    if (call.args.size() != 3)
      return wrong("a shader, a name and a variable");
    checkTarget(call.args[2], false, call.args[2]->loc, "output argument 3 of 'getvar'");
    if (!componentsOf(call.args[2]->type)) {
      diags
          .error(call.args[2]->loc,
                 "'getvar' gives numbers, not a '" + toString(call.args[2]->type) + "'")
          .range(call.args[2]->range);
      return failed(&call);
    }
    call.hasEffects = true;
    call.type = {TypeKind::Float};
    return &call;
  case CoshaderOp::Member:
  case CoshaderOp::Method:
    break;
  }
  llvm_unreachable("not written as a call of a name");
}

/// What a method or parameter of unknown type gives: what the context wants.
static Type wantedType(TypeKind hint, bool varying) {
  Type type{hint, varying};
  return componentsOf(type) ? type : Type{TypeKind::Float, varying};
}

/// Text is what another shader's members and methods cannot give.
static bool isText(TypeKind kind) { return kind == TypeKind::String || kind == TypeKind::Shader; }

/// handle->member, a parameter of the other shader
Expr *Sema::checkRemoteMember(MemberExpr &member, TypeKind hint) {
  auto *call =
      ast.make<CallExpr>(member.nameRange, member.range, member.name, MutableArrayRef<Expr *>());
  call->object = member.base;
  call->form = CallForm::Coshader;
  call->coshaderOp = CoshaderOp::Member;
  call->type = isText(hint) ? Type{hint} : wantedType(hint, member.base->type.varying);
  call->hasEffects = member.base->hasEffects;
  call->depth = member.depth;
  call->remoteName = ast.save("." + member.name);
  if (isText(hint))
    refuseRemote(*call, member.loc, "another shader's text is not known here");
  return call;
}

/// The renderer is not asked, and the result is 0 or "".
void Sema::refuseRemote(CallExpr &call, SMLoc loc, const Twine &why) {
  diags.warning(loc, warn::Unanswered, why + "; '" + call.name + "' is not called")
      .range(call.nameRange);
  call.remoteName = "";
}

/// handle->method(arguments). Variables among the arguments get back what the method makes of them.
Expr *Sema::checkRemoteCall(CallExpr &call, TypeKind hint) {
  call.form = CallForm::Coshader;
  call.coshaderOp = CoshaderOp::Method;
  call.hasEffects = true;
  useVarying();
  for (Expr *&arg : call.args) {
    arg = check(arg);
    if (arg->type.isError())
      return failed(&call);
    if (arg->type.is(TypeKind::Bool))
      arg = convert(arg, {TypeKind::Float, true}, "an argument");
  }
  SmallVector<Expr *, 4> steps;
  flattenArguments(call, steps);
  call.type = hint == TypeKind::Error ? Type{TypeKind::Void}
              : isText(hint)          ? Type{hint, true}
                                      : wantedType(hint, true);
  std::string letters;
  unsigned numbers = 0;
  const Expr *odd = nullptr; // what is no number
  for (Expr *arg : call.args) {
    numbers += componentsOf(arg->type);
    odd = odd || componentsOf(arg->type) ? odd : arg;
    if (!odd)
      letters += letter(arg->type);
  }
  call.remoteName = ast.save(call.name + "(" + letters + ")" + Twine(letter(call.type)));
  if (odd)
    refuseRemote(call, odd->loc,
                 "a value of type '" + toString(odd->type) +
                     "' cannot be handed to another shader");
  else if (isText(call.type.kind))
    refuseRemote(call, call.loc, "another shader cannot give a '" + toString(call.type) + "'");
  else if (std::max(numbers, componentsOf(call.type)) > 2 * MatrixSize)
    refuseRemote(call, call.loc,
                 Twine(numbers) + " numbers are more than the " + Twine(2 * MatrixSize) +
                     " that can be handed to another shader");
  for (Expr *arg : call.args)
    if (auto *name = dyn_cast<NameExpr>(arg); name && isRemoteOutput(*name->decl))
      checkTarget(arg, arg->type.varying, arg->loc, "an argument of another shader's method");
  return sequence(steps, &call, call.range);
}

/// Whether a variable that is an argument gets a value back.
bool isRemoteOutput(const VarDecl &decl) {
  bool isOwn = decl.kind == VarKind::Local || decl.isOutput;
  return isOwn || (decl.kind == VarKind::Global && (decl.name == "Ci" || decl.name == "Oi"));
}

//===-- Methods that others call ----------------------------------------------------------------//

static Expr *numberAt(Ast &ast, SMRange range, double value) {
  return ast.make<NumberExpr>(range, value);
}

/// Number `i` of the arguments.
static Expr *argumentAt(Ast &ast, VarDecl &arguments, SMRange range, unsigned i) {
  auto *name = ast.make<NameExpr>(range, arguments.name);
  Expr *element =
      ast.make<IndexExpr>(range.Start, range, name, numberAt(ast, range, i / MatrixSize));
  Expr *args[] = {element, numberAt(ast, range, i % MatrixSize / 4), numberAt(ast, range, i % 4)};
  return ast.make<CallExpr>(range, range, "comp", ast.copy<Expr *>(args));
}

/// Makes shaders of a class's public methods; its members are in scope, and `begin` is what comes
/// before any method.
void Sema::makeMethods(StructDecl &decl, ArrayRef<Stmt *> begin) {
  std::set<std::string> known;
  for (FunctionDecl *method : decl.methods) {
    if (!method->isPublic || method->name == "construct" || method->name == "begin")
      continue;
    std::string letters;
    unsigned numbers = 0;
    bool fits = letter(method->result) != 0;
    for (const VarDecl *param : method->leaves) {
      numbers += componentsOf(param->type);
      fits &= componentsOf(param->type) != 0;
      letters += fits ? letter(param->type) : '?';
    }
    std::string name =
        (decl.name + "." + method->name + "(" + letters + ")" + Twine(letter(method->result)))
            .str();
    if (fits && numbers <= 2 * MatrixSize && known.insert(name).second)
      ast.shaders.push_back(makeMethod(decl, *method, name, begin));
  }
}

ShaderDecl *Sema::makeMethod(StructDecl &decl, FunctionDecl &method, StringRef name,
                             ArrayRef<Stmt *> begin) {
  SMRange range = method.range;
  auto *arguments = ast.make<VarDecl>();
  arguments->kind = VarKind::ShaderParam;
  arguments->name = "method arguments"; // no name that a shader can have
  arguments->range = range;
  arguments->type = {TypeKind::Matrix, true, 2};
  arguments->isOutput = arguments->isRead = true;
  arguments->id = unsigned(decl.params.size());
  arguments->init = zeroOf(arguments->type, range);
  std::vector<VarDecl *> params(decl.params.begin(), decl.params.end());
  params.push_back(arguments);

  pushScope();
  declare(arguments);
  SmallVector<Stmt *, 16> body(begin.begin(), begin.end());
  SmallVector<Expr *, 8> args;
  unsigned next = 0;
  for (const VarDecl *param : method.leaves) {
    Expr *value = nullptr;
    unsigned count = componentsOf(param->type);
    SmallVector<Expr *, 16> components;
    for (unsigned i = 0; i < count; ++i)
      components.push_back(argumentAt(ast, *arguments, range, next++));
    value = count == 1 ? components[0] : ast.make<TupleExpr>(range, ast.copy<Expr *>(components));
    auto *local = ast.make<VarDecl>();
    local->kind = VarKind::Local;
    local->name = ast.save("argument " + Twine(args.size()));
    local->range = range;
    local->type = param->type.withVarying(true);
    local->isRead = true;
    local->init = checkAs(value, local->type, "an argument");
    declare(local);
    args.push_back(reference(*local, range));
    body.push_back(ast.make<DeclarationStmt>(range.Start, ast.copy<VarDecl *>(local)));
  }
  auto *call = ast.make<CallExpr>(range, range, method.name, ast.copy<Expr *>(args));
  call->function = &method;
  call->hasEffects = true;
  call->type = {method.result.kind, true};
  Expr *result = call;
  if (!method.result.isError() && method.result.kind != TypeKind::Void) {
    auto *local = ast.make<VarDecl>();
    local->kind = VarKind::Local;
    local->name = "method result";
    local->range = range;
    local->type = call->type;
    local->init = call;
    local->isRead = true;
    declare(local);
    body.push_back(ast.make<DeclarationStmt>(range.Start, ast.copy<VarDecl *>(local)));
    result = reference(*local, range);
  } else {
    body.push_back(ast.make<ExpressionStmt>(call));
  }
  // The result lies behind the arguments' numbers where there is room, so that both come back.
  auto store = [&](Expr *from, unsigned at) {
    for (unsigned i = 0; i < componentsOf(from->type); ++i, ++at) {
      Expr *value = from;
      if (from->type.is(TypeKind::Matrix)) {
        Expr *indices[] = {from, numberAt(ast, range, i / 4), numberAt(ast, range, i % 4)};
        value = ast.make<CallExpr>(range, range, "comp", ast.copy<Expr *>(indices));
      } else if (from->type.isTriple()) {
        value = ast.make<IndexExpr>(range.Start, range, from, numberAt(ast, range, i));
      }
      auto *place = cast<CallExpr>(argumentAt(ast, *arguments, range, at));
      SmallVector<Expr *, 4> operands(place->args.begin(), place->args.end());
      operands.push_back(value);
      auto *set = ast.make<CallExpr>(range, range, "setcomp", ast.copy<Expr *>(operands));
      body.push_back(ast.make<ExpressionStmt>(checkCall(*set, TypeKind::Error)));
    }
  };
  unsigned at = 0;
  for (size_t i = 0; i < args.size(); ++i) {
    if (method.leaves[i]->isOutput)
      store(args[i], at);
    at += componentsOf(args[i]->type);
  }
  if (componentsOf(result->type))
    store(result, at + componentsOf(result->type) <= 2 * MatrixSize ? at : 0);
  popScope();

  auto *shader = ast.make<ShaderDecl>();
  shader->type = ShaderType::Method;
  shader->name = ast.save(name);
  shader->range = range;
  shader->params = ast.copy<VarDecl *>(params);
  shader->body = ast.make<BlockStmt>(range.Start, range.End, ast.copy<Stmt *>(body));
  return shader;
}

} // namespace anysl::rsl
