//===-- frontends/rsl/SemaCoshader.cpp - shaders that call each other -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A handle names another shader, of a class that this file knows nothing about. So a call hands
// over values, and says by letters what they are: `bump(tf3)f` is a method of a triple and an array
// of three floats that gives a float. A public method is a shader of its own under that name, whose
// body is that of the class up to its methods, and then a call of this one (MethodCall).
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

static std::optional<CoshaderOp> coshaderOp(StringRef name) {
  return StringSwitch<std::optional<CoshaderOp>>(name)
      .Case("getshader", CoshaderOp::Get)
      .Case("getshaders", CoshaderOp::GetAll)
      .Case("getlights", CoshaderOp::GetLights)
      .Case("getvar", CoshaderOp::Variable)
      .Default(std::nullopt);
}

bool isCoshaderCall(StringRef name) { return coshaderOp(name).has_value(); }

bool isTextual(TypeKind kind) { return kind == TypeKind::String || kind == TypeKind::Shader; }

char shapeLetter(Type type) {
  return type.is(TypeKind::Float)                  ? 'f'
         : type.isTriple()                         ? 't'
         : type.is(TypeKind::Matrix)               ? 'm'
         : !type.isArray() && isTextual(type.kind) ? 's'
         : type.is(TypeKind::Void)                 ? 'v'
                                                   : 0;
}

/// Whether values of a type can be handed to another shader.
static bool isSendable(Type type) {
  char letter = shapeLetter(type.element());
  return letter != 0 && letter != 'v';
}

unsigned componentsOf(Type type) {
  return type.is(TypeKind::Float) ? 1 : type.isTriple() ? 3 : type.is(TypeKind::Matrix) ? 16 : 0;
}

//===-- Calls -----------------------------------------------------------------------------------//

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
  case CoshaderOp::GetAll:
    if (call.args.size() != 0 && call.args.size() != 2)
      return wrong("nothing, or \"category\" and its name");
    call.type = {TypeKind::Shader, false, options.arrayCapacity, nullptr, true};
    return &call;
  case CoshaderOp::Variable:
    if (call.args.size() != 3)
      return wrong("a shader, a name and a variable");
    checkTarget(call.args[2], false, call.args[2]->loc, "output argument 3 of 'getvar'");
    if (call.args[2]->type.isError())
      return failed(&call);
    if (!isSendable(call.args[2]->type)) {
      diags
          .error(call.args[2]->loc, "'getvar' cannot give a '" + toString(call.args[2]->type) + "'")
          .range(call.args[2]->range);
      return failed(&call);
    }
    raiseCapacity(call.args[2], options.arrayCapacity);
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
  return isSendable(type) ? type : Type{TypeKind::Float, varying};
}

/// handle->member, a parameter of the other shader
Expr *Sema::checkRemoteMember(MemberExpr &member, TypeKind hint) {
  auto *call =
      ast.make<CallExpr>(member.nameRange, member.range, member.name, MutableArrayRef<Expr *>());
  call->object = member.base;
  call->form = CallForm::Coshader;
  call->coshaderOp = CoshaderOp::Member;
  call->hasEffects = member.base->hasEffects;
  call->depth = member.depth;
  call->remoteName = member.name;
  if (!member.wanted.structure) // parameters are no structures
    call->wanted = member.wanted;
  SmallVector<Expr *, 2> steps;
  return setRemoteResult(*call, steps, wantedType(hint, member.base->type.varying));
}

/// The call is what it gives, of type `other`, unless its context wants an array or a structure:
/// then it is a step that sets a variable, which is the value.
Expr *Sema::setRemoteResult(CallExpr &call, SmallVectorImpl<Expr *> &steps, Type other) {
  call.type = other;
  if (call.wanted.isError())
    return sequence(steps, &call, call.range);
  call.type = {TypeKind::Void};
  call.hasEffects = true;
  Type type = call.wanted.withVarying(true);
  if (type.isArray() && (type.isResizable || type.length == Type::AnyLength)) {
    type.length = std::max(type.length, options.arrayCapacity);
    type.isResizable = true;
  }
  NameExpr *result = hiddenVariable(type, call.range);
  SmallVector<VarDecl *, 8> leaves;
  appendLeaves(result->decl, leaves);
  call.results = ast.copy<VarDecl *>(leaves);
  steps.push_back(&call);
  return sequence(steps, result, call.range);
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
  call.remoteName = call.name;
  for (Expr *arg : call.args) {
    if (!isSendable(arg->type) && !call.remoteName.empty()) {
      diags
          .warning(arg->loc, warn::Unanswered,
                   "a value of type '" + toString(arg->type) +
                       "' cannot be handed to another shader; '" + call.name + "' is not called")
          .range(arg->range);
      call.remoteName = "";
    }
    auto *name = dyn_cast<NameExpr>(arg);
    if (name && isRemoteOutput(*name->decl))
      checkTarget(arg, arg->type.varying, arg->loc, "an argument of another shader's method");
  }
  return setRemoteResult(call, steps,
                         hint == TypeKind::Error ? Type{TypeKind::Void} : wantedType(hint, true));
}

/// Whether a variable that is an argument gets a value back.
bool isRemoteOutput(const VarDecl &decl) {
  bool isOwn = decl.kind == VarKind::Local || decl.isOutput;
  return isOwn || (decl.kind == VarKind::Global && (decl.name == "Ci" || decl.name == "Oi"));
}

//===-- Methods that others call ----------------------------------------------------------------//

/// The variables that a method's result consists of; none if it is a number or text.
SmallVector<VarDecl *, 8> Sema::resultLeaves(const FunctionDecl &method) {
  SmallVector<VarDecl *, 8> leaves;
  if (method.resultVariable)
    appendLeaves(method.resultVariable, leaves);
  return leaves;
}

/// How a type is written in a method's name; "" if values of it cannot be handed over. An array of
/// any length gets room for the usual number of elements.
std::string Sema::shapeOf(Type &type, int wantedCapacity) const {
  if (!isSendable(type))
    return "";
  std::string shape(1, shapeLetter(type.element()));
  if (type.length == Type::AnyLength) {
    type.length = std::max(options.arrayCapacity, wantedCapacity);
    type.isResizable = true;
  }
  if (type.isArray())
    shape += (type.isResizable ? "*" : "") + std::to_string(type.length);
  return shape;
}

/// Makes shaders of a class's public methods; its members are in scope, and `begin` is what comes
/// before any method.
void Sema::makeMethods(StructDecl &decl, ArrayRef<Stmt *> begin) {
  std::set<std::string> known;
  for (FunctionDecl *method : decl.methods) {
    if (!method->isPublic || method->name == "construct" || method->name == "begin")
      continue;
    bool fits = true;
    auto shapesOf = [&](ArrayRef<VarDecl *> values, std::vector<Type> *types) {
      std::string shapes;
      for (const VarDecl *value : values) {
        Type type = value->type.withVarying(true);
        std::string shape = shapeOf(type, value->wantedCapacity);
        fits &= !shape.empty();
        shapes += shape;
        if (types)
          types->push_back(type);
      }
      return shapes;
    };
    std::vector<Type> types;
    std::string shapes = shapesOf(method->leaves, &types);
    std::string result = method->resultVariable ? shapesOf(resultLeaves(*method), nullptr)
                                                : std::string(1, shapeLetter(method->result));
    std::string name = (decl.name + "." + method->name + "(" + shapes + ")" + result).str();
    if (fits && known.insert(name).second)
      ast.shaders.push_back(makeMethod(decl, *method, name, types, begin));
  }
}

ShaderDecl *Sema::makeMethod(StructDecl &decl, FunctionDecl &method, StringRef name,
                             ArrayRef<Type> types, ArrayRef<Stmt *> begin) {
  SMRange range = method.range;
  // As many numbers and texts as there are in the arguments and the result.
  int numbers = 0, texts = 0;
  auto count = [&](Type type) {
    int elements = type.isArray() ? type.length : 1;
    numbers += type.isResizable;
    (isTextual(type.kind) ? texts : numbers) +=
        elements * (isTextual(type.kind) ? 1 : int(componentsOf(type.element())));
  };
  SmallVector<VarDecl *, 8> arguments;
  SmallVector<Expr *, 8> references;
  for (Type type : types) {
    auto *argument = ast.make<VarDecl>();
    argument->kind = VarKind::Local;
    argument->name = ast.save("argument " + Twine(arguments.size()));
    argument->range = range;
    argument->type = type;
    argument->isRead = argument->isAssigned = true;
    arguments.push_back(argument);
    references.push_back(reference(*argument, range));
    count(type);
  }
  auto *call = ast.make<CallExpr>(range, range, method.name, ast.copy<Expr *>(references));
  call->function = &method;
  call->hasEffects = true;
  call->type = {method.resultVariable ? TypeKind::Void : method.result.kind, true};
  call->results = ast.copy<VarDecl *>(resultLeaves(method));
  for (const VarDecl *result : call->results)
    count(result->type);
  if (!call->type.is(TypeKind::Void))
    count(method.result);

  std::vector<VarDecl *> params(decl.params.begin(), decl.params.end());
  auto addArray = [&](StringRef what, TypeKind kind, int length) -> VarDecl * {
    if (length == 0)
      return nullptr;
    auto *array = ast.make<VarDecl>();
    array->kind = VarKind::ShaderParam;
    array->name = what; // no name that a shader can have
    array->range = range;
    array->type = {kind, true, length};
    array->isOutput = array->isRead = true;
    array->id = unsigned(params.size());
    array->init = zeroOf(array->type, range);
    params.push_back(array);
    return array;
  };
  auto *shader = ast.make<ShaderDecl>();
  shader->method = ast.make<MethodCall>();
  shader->method->call = call;
  shader->method->arguments = ast.copy<VarDecl *>(arguments);
  shader->method->numbers = addArray("method numbers", TypeKind::Float, numbers);
  shader->method->texts = addArray("method texts", TypeKind::String, texts);
  shader->type = ShaderType::Method;
  shader->name = ast.save(name);
  shader->range = range;
  shader->params = ast.copy<VarDecl *>(params);
  shader->body = ast.make<BlockStmt>(range.Start, range.End, ast.copy<Stmt *>(begin));
  return shader;
}

} // namespace anysl::rsl
