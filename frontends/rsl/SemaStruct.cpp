//===-- frontends/rsl/SemaStruct.cpp - structures ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A variable of a structure is one variable for each member, and what is done to the whole is done
// to each member; lowering never sees a structure. An expression of a structure's type is, once
// checked, a variable (or an array's element), maybe behind the steps that compute it (CommaExpr).
//
// Methods are functions that see the members as variables around them. Their bodies are checked
// once; a call says in `self` which variables stand for the members.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

void Sema::checkStruct(StructDecl &decl) {
  auto [entry, isNew] = scopes.back().structs.try_emplace(decl.name, &decl);
  if (!isNew)
    diags.error(decl.range.Start, "redefinition of '" + decl.name + "'")
        .range(decl.range)
        .note(entry->second->range.Start, "previously defined here", entry->second->range);
  checkMembers(decl);
}

/// The members and methods of a structure or class. Members are declared as if in a block around
/// the methods, which may call each other in any order.
void Sema::checkMembers(StructDecl &decl) {
  pushScope();
  for (StructDecl *inner : decl.inner)
    checkStruct(*inner);
  for (VarDecl *member : decl.members) {
    if (!decl.isClass && member->type.structure && member->init) {
      diags
          .error(member->init->loc, "the default of a structure stands in its own definition, not "
                                    "where it is a member")
          .range(member->init->range);
      member->init = nullptr;
    }
    checkVariable(*member);
    member->isRead = true; // whether anybody reads it is the users' affair
  }
  SmallVector<VarDecl *, 16> leaves;
  appendLeaves(decl.members, leaves);
  decl.leaves = ast.copy<VarDecl *>(leaves);
  for (FunctionDecl *method : decl.methods)
    declareFunction(*method);
  StructDecl *outerStructure = std::exchange(structure, &decl);
  size_t outerScope = std::exchange(structureScope, scopes.size());
  for (FunctionDecl *method : decl.methods)
    checkMethod(*method);
  if (decl.isClass)
    makeEntries(decl);
  structure = outerStructure;
  structureScope = outerScope;
  popScope();
}

/// Checks a method's body if that has not been done, as if it stood where the structure is.
void Sema::checkMethod(FunctionDecl &method) {
  if (method.isChecked || method.isBeingChecked)
    return;
  std::vector<Scope> inner(std::make_move_iterator(scopes.begin() + ptrdiff_t(structureScope)),
                           std::make_move_iterator(scopes.end()));
  scopes.resize(structureScope);
  FunctionDecl *caller = std::exchange(function, method.outer);
  checkBody(method);
  function = caller;
  llvm::move(inner, std::back_inserter(scopes));
}

/// Makes the variables that a variable of a structure consists of.
void Sema::expandStruct(VarDecl &decl) {
  std::vector<VarDecl *> members;
  bool isUniform = decl.hasStorage && !decl.type.varying;
  for (const VarDecl *member : decl.type.structure->members) {
    auto *part = ast.make<VarDecl>(*member);
    part->kind = decl.kind;
    part->name = ast.save(decl.name + "." + member->name);
    part->range = decl.range;
    part->owner = decl.owner;
    part->isOutput = decl.isOutput;
    part->isHidden = decl.isHidden;
    part->isRead = true;
    part->isAssigned = part->isCopied = false;
    // Structures have no storage class of their own: `uniform` is handed on to the members.
    part->hasStorage = !member->type.structure || member->hasStorage || isUniform;
    part->type.varying &= !isUniform;
    part->members = {};
    if (decl.type.isArray()) {
      if (member->type.isArray())
        diags
            .error(decl.range.Start, "an array of '" + decl.type.structure->name +
                                         "', whose member '" + member->name +
                                         "' is an array itself, is not supported")
            .range(decl.range);
      part->type.length = decl.type.length;
    }
    if (part->type.structure)
      expandStruct(*part);
    members.push_back(part);
  }
  decl.members = ast.copy<VarDecl *>(members);
}

/// The variables behind a list of variables, structures as their members.
void Sema::appendLeaves(ArrayRef<VarDecl *> decls, SmallVectorImpl<VarDecl *> &leaves) {
  for (VarDecl *decl : decls)
    if (decl->type.structure)
      appendLeaves(decl->members, leaves);
    else
      leaves.push_back(decl);
}

/// A variable of a structure, or an array, that no declaration makes.
NameExpr *Sema::hiddenVariable(Type type, SMRange range) {
  auto *decl = ast.make<VarDecl>();
  decl->kind = VarKind::Local;
  decl->name = ast.save("a '" + toString(type) + "'");
  decl->range = range;
  decl->type = type;
  decl->owner = function;
  decl->isHidden = true;
  decl->isRead = true;
  if (type.structure)
    expandStruct(*decl);
  return reference(*decl, range);
}

NameExpr *Sema::reference(VarDecl &decl, SMRange range) {
  auto *name = ast.make<NameExpr>(range, decl.name);
  name->decl = &decl;
  name->type = decl.type;
  return name;
}

/// The steps and then the value.
Expr *Sema::sequence(ArrayRef<Expr *> steps, Expr *value, SMRange range) {
  if (steps.empty())
    return value;
  std::vector<Expr *> elements(steps.begin(), steps.end());
  elements.push_back(value);
  auto *list = ast.make<CommaExpr>(range, ast.copy<Expr *>(elements));
  list->type = value->type;
  list->hasEffects = true;
  for (const Expr *element : elements)
    list->depth = std::max(list->depth, element->depth + 1);
  return list;
}

/// Splits what computes a structure from the variable where it then is.
Expr *Sema::splitSteps(Expr *expr, SmallVectorImpl<Expr *> &steps) {
  while (auto *list = dyn_cast<CommaExpr>(expr)) {
    llvm::append_range(steps, list->elements.drop_back());
    expr = list->elements.back();
  }
  // The value of an assignment is its target afterwards.
  return expr;
}

/// Member number `i` of a checked structure without steps.
Expr *Sema::memberOf(Expr *base, size_t i) {
  if (auto *index = dyn_cast<IndexExpr>(base)) {
    Expr *array = memberOf(index->base, i);
    auto *element = ast.make<IndexExpr>(index->loc, index->range, array, index->index);
    element->type = array->type.element();
    element->type.varying |= index->index->type.varying;
    element->hasEffects = index->hasEffects;
    element->depth = index->depth;
    return element;
  }
  VarDecl *member = cast<NameExpr>(base)->decl->members[i];
  if (function && member->owner != function) {
    function->usesOuter = true;
    if (member->type.varying)
      useVarying();
  }
  return reference(*member, base->range);
}

/// All members of a checked structure without steps, nested ones too.
void Sema::appendMembers(Expr *base, SmallVectorImpl<Expr *> &members) {
  for (size_t i = 0; i < base->type.structure->members.size(); ++i) {
    Expr *member = memberOf(base, i);
    if (member->type.structure)
      appendMembers(member, members);
    else
      members.push_back(member);
  }
}

//===-- Members ---------------------------------------------------------------------------------//

/// Whether an expression is the word `this` and no variable.
bool Sema::isThis(const Expr *expr) {
  auto *name = dyn_cast<NameExpr>(expr);
  return name && name->name == "this" && !lookup("this");
}

/// The member or class parameter that `this->name` means; null if there is none.
VarDecl *Sema::lookupOwn(StringRef name) {
  if (!structure)
    return nullptr;
  // A class's parameters stand in the scope around its members.
  for (size_t depth : {structureScope - 1, structureScope - 2}) {
    if (VarDecl *found = scopes[depth].variables.lookup(name);
        found && found->kind != VarKind::Global)
      return found;
    if (!structure->isClass)
      break;
  }
  return nullptr;
}

static const VarDecl *memberNamed(const StructDecl &decl, StringRef name, size_t *number) {
  for (size_t i = 0; i < decl.members.size(); ++i)
    if (decl.members[i]->name == name) {
      *number = i;
      return decl.members[i];
    }
  return nullptr;
}

Type Sema::probeMember(const MemberExpr &member) {
  if (isThis(member.base)) {
    VarDecl *own = lookupOwn(member.name);
    return own ? own->type : Type();
  }
  Type base = probe(member.base);
  size_t number;
  const VarDecl *found =
      base.isStruct() ? memberNamed(*base.structure, member.name, &number) : nullptr;
  return found ? found->type : Type();
}

Expr *Sema::checkMember(MemberExpr &member, TypeKind hint) {
  if (isThis(member.base)) {
    VarDecl *own = lookupOwn(member.name);
    if (own) {
      own->isRead = true;
      if (function && own->owner != function) {
        function->usesOuter = true;
        if (own->type.varying)
          useVarying();
      }
      return reference(*own, member.range);
    }
    diags
        .error(member.loc,
               structure ? ("'" + structure->name + "' has no member '" + member.name + "'").str()
                         : "'this' exists only in methods")
        .range(member.nameRange);
    return failed(&member);
  }
  member.base = check(member.base);
  Type base = member.base->type;
  if (base.isError())
    return failed(&member);
  if (base.is(TypeKind::Shader))
    return checkRemoteMember(member, hint);
  if (!base.isStruct()) {
    diags.error(member.loc, "a value of type '" + toString(base) + "' has no members")
        .range(member.base->range);
    return failed(&member);
  }
  size_t number = 0;
  if (!memberNamed(*base.structure, member.name, &number)) {
    std::vector<StringRef> names;
    for (const VarDecl *known : base.structure->members)
      names.push_back(known->name);
    auto error = diags.error(member.loc, "'" + base.structure->name + "' has no member '" +
                                             member.name + "'" + didYouMean(member.name, names));
    error.range(member.nameRange)
        .note(base.structure->range.Start, "declared here", base.structure->range);
    if (std::optional<StringRef> likely = suggest(member.name, names))
      error.fixit(member.nameRange, *likely);
    return failed(&member);
  }
  SmallVector<Expr *, 4> steps;
  Expr *place = splitSteps(member.base, steps);
  Expr *result = memberOf(place, number);
  result->range = member.range;
  result->depth = member.depth;
  return sequence(steps, result, member.range);
}

/// `a.b` where a is a structure was parsed as a dot product; what it means instead, or null. A dot
/// product binds less tightly than a member should: -a.b came as (-a).b, v.a.b as (v.a).b.
Expr *Sema::dotAsMember(BinaryExpr &dot) {
  if (dot.meaning)
    return dot.meaning;
  Expr **holder = &dot.left;
  while (true) {
    if (auto *negate = dyn_cast<NegateExpr>(*holder))
      holder = &negate->operand;
    else if (auto *inversion = dyn_cast<NotExpr>(*holder))
      holder = &inversion->operand;
    else if (auto *cast = dyn_cast<CastExpr>(*holder); cast && !cast->isImplicit)
      holder = &cast->operand;
    else if (auto *outer = dyn_cast<BinaryExpr>(*holder);
             outer && outer->op == BinaryOp::Dot && !dotAsMemberInner(*outer))
      holder = &outer->right;
    else
      break;
  }
  if (!isa<NameExpr, IndexExpr, MemberExpr, BinaryExpr>(*holder) || !probe(*holder).isStruct())
    return nullptr;
  Expr *base = *holder;
  Expr *right = dot.right;
  SmallVector<IndexExpr *, 2> indices;
  while (auto *index = dyn_cast<IndexExpr>(right)) {
    indices.push_back(index);
    right = index->base;
  }
  SMRange range{base->range.Start, right->range.End};
  Expr *result = nullptr;
  if (auto *name = dyn_cast<NameExpr>(right)) {
    result = ast.make<MemberExpr>(range, base, name->name, name->range);
  } else if (auto *call = dyn_cast<CallExpr>(right); call && !call->object) {
    call->object = base;
    call->range = range;
    result = call;
  } else {
    return nullptr;
  }
  result->depth = std::max(base->depth + 1, right->depth);
  for (IndexExpr *index : llvm::reverse(indices)) {
    index->base = result;
    result = index;
  }
  if (holder == &dot.left)
    return dot.meaning = result;
  *holder = result;
  return dot.meaning = dot.left;
}

bool Sema::dotAsMemberInner(BinaryExpr &dot) {
  return probe(dot.left).isStruct() && isa<NameExpr, IndexExpr>(dot.right);
}

//===-- Whole structures ------------------------------------------------------------------------//

/// Assigns each member; `steps` gets the assignments.
void Sema::assignMembers(Expr *target, Expr *value, SMLoc loc, SmallVectorImpl<Expr *> &steps) {
  SmallVector<Expr *, 8> targets, values;
  appendMembers(target, targets);
  appendMembers(value, values);
  for (size_t i = 0; i < targets.size(); ++i)
    steps.push_back(assignment(targets[i], values[i], loc));
}

Expr *Sema::assignment(Expr *target, Expr *value, SMLoc loc) {
  auto *assign = ast.make<AssignExpr>(loc, target->range, target, value);
  assign->type = target->type;
  assign->hasEffects = true;
  assign->depth = std::max(target->depth, value->depth) + 1;
  checkTarget(target, value->type.varying, loc, "'='");
  return assign;
}

/// target = value, of a structure; both are checked.
Expr *Sema::assignStruct(Expr *target, Expr *value, SMLoc loc, SMRange range) {
  SmallVector<Expr *, 8> steps;
  value = splitSteps(value, steps);
  target = splitSteps(target, steps);
  assignMembers(target, value, loc, steps);
  return sequence(steps, target, range);
}

/// The initialiser of a variable of a structure becomes an assignment behind its declaration.
void Sema::initialiseStruct(VarDecl &decl) {
  auto *list = dyn_cast<ListExpr>(decl.init);
  NameExpr *name = reference(decl, decl.range);
  if (!list || !decl.type.isArray()) {
    std::string what = ("initialising '" + decl.name + "'").str();
    Expr *value = checkWhole(decl.init, decl.type, what);
    decl.init = value->type.isError()
                    ? value
                    : assignStruct(name, value, decl.range.Start, decl.init->range);
    return;
  }
  if (static_cast<int>(list->elements.size()) > decl.type.length)
    diags
        .error(list->loc,
               Twine(list->elements.size()) + " values for an array of " + Twine(decl.type.length))
        .range(list->range);
  SmallVector<Expr *, 8> steps;
  for (size_t i = 0; i < list->elements.size(); ++i) {
    auto *number = ast.make<NumberExpr>(list->range, double(i));
    number->type = {TypeKind::Float};
    auto *element = ast.make<IndexExpr>(decl.range.Start, decl.range, name, number);
    element->type = decl.type.element();
    Expr *value = checkWhole(list->elements[i], element->type, "an element");
    if (!value->type.isError())
      steps.push_back(assignStruct(element, value, decl.range.Start, list->elements[i]->range));
  }
  decl.init = sequence(steps, name, list->range);
}

/// S(), S(values in the order of the members) or S("member", value, …). Members that are not given
/// have their defaults.
Expr *Sema::checkConstructor(CallExpr &call, StructDecl &decl) {
  NameExpr *result = hiddenVariable({TypeKind::Struct, true, Type::NoArray, &decl}, call.range);
  SmallVector<Expr *, 8> given(decl.members.size(), nullptr), steps;
  size_t ignored;
  auto *first = call.args.empty() ? nullptr : dyn_cast<StringExpr>(call.args[0]);
  bool isNamed = first && call.args.size() % 2 == 0 && memberNamed(decl, first->value, &ignored);
  bool bad = false;
  for (size_t i = 0; i < call.args.size(); i += isNamed ? 2 : 1) {
    size_t number = i;
    if (isNamed) {
      auto *name = dyn_cast<StringExpr>(call.args[i]);
      if (!name || !memberNamed(decl, name->value, &number)) {
        diags.error(call.args[i]->loc, "expected the name of a member of '" + decl.name + "'")
            .range(call.args[i]->range);
        return failed(&call);
      }
    } else if (i >= decl.members.size()) {
      diags
          .error(call.args[i]->loc,
                 "'" + decl.name + "' has only " + Twine(decl.members.size()) + " members")
          .range(call.args[i]->range)
          .note(decl.range.Start, "declared here", decl.range);
      return failed(&call);
    }
    Type type = decl.members[number]->type;
    std::string what = ("member '" + decl.members[number]->name + "' of '" + decl.name + "'").str();
    Expr *&value = call.args[isNamed ? i + 1 : i];
    auto *list = dyn_cast<ListExpr>(value);
    value = list && type.isArray() && !type.structure ? checkList(*list, type)
                                                      : checkAs(value, type, what);
    bad |= !checkStorage(value, type.varying || type.structure, what + ", which is uniform");
    bad |= value->type.isError();
    given[number] = value;
  }
  if (bad)
    return failed(&call);
  for (size_t i = 0; i < given.size(); ++i) {
    Expr *target = memberOf(result, i);
    if (given[i] && target->type.structure)
      steps.push_back(assignStruct(target, given[i], call.loc, call.range));
    else if (given[i])
      steps.push_back(assignment(target, given[i], call.loc));
    else
      assignDefaults(*result->decl->members[i], steps);
  }
  return sequence(steps, result, call.range);
}

/// A member of a hidden variable gets the value that its declaration says.
void Sema::assignDefaults(VarDecl &member, SmallVectorImpl<Expr *> &steps) {
  for (VarDecl *part : member.members)
    assignDefaults(*part, steps);
  if (!member.type.structure && member.init && !member.init->type.isError())
    steps.push_back(assignment(reference(member, member.range), member.init, member.range.Start));
  else if (!member.type.structure && !member.init)
    steps.push_back(assignment(reference(member, member.range), zeroOf(member.type, member.range),
                               member.range.Start));
}

Expr *Sema::zeroOf(Type type, SMRange range) {
  if (type.isArray()) {
    auto *list = ast.make<ListExpr>(range, MutableArrayRef<Expr *>());
    list->type = type.withVarying(false);
    return list;
  }
  if (type.is(TypeKind::String) || type.is(TypeKind::Shader)) {
    auto *text = ast.make<StringExpr>(range, "");
    text->type = {type.kind};
    return text;
  }
  auto *number = ast.make<NumberExpr>(range, 0.0);
  number->type = {TypeKind::Float};
  return convert(number, type, "a default");
}

//===-- Calls -----------------------------------------------------------------------------------//

/// Structures among a call's arguments become their members.
void Sema::flattenArguments(CallExpr &call, SmallVectorImpl<Expr *> &steps) {
  SmallVector<Expr *, 16> flat;
  for (Expr *arg : call.args) {
    if (!arg->type.structure) {
      flat.push_back(arg);
      continue;
    }
    appendMembers(splitSteps(arg, steps), flat);
  }
  call.args = ast.copy<Expr *>(flat);
}

/// Which variables stand for the members in a method that is called on something.
void Sema::bindObject(CallExpr &call, SmallVectorImpl<Expr *> &steps) {
  SmallVector<Expr *, 16> self;
  appendMembers(splitSteps(call.object, steps), self);
  call.self = ast.copy<Expr *>(self);
}

/// A call of a function that returns a structure or an array: the function's own result variable is
/// copied, for the next call changes it.
Expr *Sema::copyResult(CallExpr &call, SmallVectorImpl<Expr *> &steps) {
  VarDecl *source = call.function->resultVariable;
  call.type = {TypeKind::Void};
  steps.push_back(&call);
  NameExpr *result = hiddenVariable(source->type, call.range);
  if (source->type.structure)
    assignMembers(result, reference(*source, call.range), call.loc, steps);
  else
    steps.push_back(assignment(result, reference(*source, call.range), call.loc));
  return sequence(steps, result, call.range);
}

} // namespace anysl::rsl
