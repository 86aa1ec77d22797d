//===-- frontends/rsl/Lowering.h - what the parts of the lowering share -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Values. The result of an operator goes to a fresh slot, and an output argument is copied in and
// out, so that no operator ever sees one slot twice. Only the value of a variable is its own slot;
// where something evaluated later could change it, it is copied first.
//
// Functions are expanded where they are called: their variables get fresh slots, read-only
// arguments are handed over as slots, results and output arguments as copies.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_LOWERING_H
#define ANYSL_FRONTENDS_RSL_LOWERING_H

#include "frontends/rsl/Ast.h"
#include "frontends/rsl/Builtins.h"
#include "lib/STC/Builder.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/ADT/DenseMap.h"
#include <map>
#include <set>

namespace anysl::rsl {

class Lowering {
public:
  Lowering(DiagnosticEngine &diags, llvm::LLVMContext &context, llvm::StringRef sourceFile,
           bool debugInfo);

  void lowerShader(const ShaderDecl &shader);
  void lowerLibraryFunction(const FunctionDecl &function);
  std::unique_ptr<llvm::Module> finish() { return b.finish(); }

private:
  using Value = llvm::Value;

  /// What can be assigned: a slot, or one component of a triple in it.
  struct Place {
    Value *slot = nullptr;
    Type type;                  ///< of the slot
    Value *component = nullptr; ///< a float slot that says which
  };
  struct Loop {
    llvm::BasicBlock *onBreak;
    llvm::BasicBlock *onContinue;
  };
  /// Values that another shader is given, or asked for: where each lies among numbers and texts.
  struct Message {
    struct Item {
      Type type;
      unsigned capacity = 0; ///< elements that an array has room for; 0: not an array
      unsigned number = 0, text = 0;
    };
    llvm::SmallVector<Item, 8> items;
    unsigned numberCount = 0, textCount = 0;
    Value *numbers = nullptr, *texts = nullptr;
  };
  /// The light that illuminance is at; index null: none.
  struct CurrentLight {
    Value *index = nullptr, *position = nullptr, *normal = nullptr;
    Value *sentNames = nullptr; ///< null: nothing is sent
    Message sent;
  };

  // Shaders (Lower.cpp)
  void at(SMLoc loc);
  void beginBody();
  void loadGlobal(unsigned id, Value *slot);
  void lowerInit(const ShaderDecl &shader, stc::ShaderInfo &info);
  void loadParam(const VarDecl &param, const stc::ParamInfo &info, Value *slot);
  void loadUniformParam(const stc::ParamInfo &info, Value *slot);
  void loadUsedParams(const ShaderDecl &shader, const stc::ShaderInfo &info);
  void storeOutputs(const ShaderDecl &shader, const stc::ShaderInfo &info);
  bool mayReadBeforeWrite(Value *slot);
  Value *globalSlot(const VarDecl &global);
  Value *globalSlot(unsigned id);
  Value *paramSlot(const VarDecl &param);
  Value *slotOf(const VarDecl &decl);
  Value *elementOf(Value *array, unsigned i) { return b.element(array, b.index(int(i))); }

  // Statements (LowerStmt.cpp)
  void lower(const Stmt *stmt);
  void lowerBody(const BlockStmt &block);
  void lowerVariable(const VarDecl &decl);
  void lowerIf(const IfStmt &stmt);
  void lowerLoop(const LoopStmt &stmt);
  void lowerReturn(const ReturnStmt &stmt);
  void lowerGather(const GatherStmt &stmt); // LowerGather.cpp
  Value *packAsked(const GatherStmt &stmt, Message &message);
  bool isOpen() const { return !builder().GetInsertBlock()->getTerminator(); }
  void branchTo(llvm::BasicBlock *block);
  void branchIf(Value *condition, llvm::BasicBlock *whenTrue, llvm::BasicBlock *whenFalse);
  void continueIn(llvm::BasicBlock *block);

  // Lights (LowerLight.cpp)
  static unsigned globalNumber(llvm::StringRef name);
  void lowerIlluminance(const LightStmt &stmt);
  void lowerIlluminate(const LightStmt &stmt);
  bool startLightResult(unsigned id, Value *slot);
  void finishLight();
  Value *askLight(Value *name, const Expr *variable, SMLoc loc);
  void packSent(const LightStmt &stmt, CurrentLight &light);
  Value *callLightSource(const CallExpr &call);

  // Expressions (LowerExpr.cpp)
  Value *lower(const Expr *expr);
  static bool mayBeVariable(const Expr *expr);
  Value *lowerBefore(const Expr *expr, bool effectsFollow);
  Value *lowerLasting(const Expr *expr) { return expr ? lowerBefore(expr, true) : nullptr; }
  Value *lowerCondition(const Expr *expr);
  Value *lowerBinary(const BinaryExpr &binary);
  Value *lowerConditional(const ConditionalExpr &conditional);
  Value *lowerAssign(const AssignExpr &assign);
  Value *lowerTuple(const TupleExpr &tuple);
  Value *lowerCast(const CastExpr &cast);
  Value *lowerIndex(const IndexExpr &index);
  void lowerListInto(const ListExpr &list, Value *array);
  Place place(const Expr *target);
  Value *load(const Place &place, Type type);
  void store(const Place &place, Value *value);
  Value *convert(Value *value, Type from, Type to);
  Value *temporary(Type type, llvm::StringRef name = "");
  void copy(Type type, Value *to, Value *from);
  Value *copied(Type type, Value *value);
  Value *number(double value);
  Value *text(llvm::StringRef value);
  Value *zero(Type type);
  void setZero(Type type, Value *slot);
  Value *spaceMatrix(Value *from, Value *to, SMLoc loc);

  // Values for other shaders (LowerMessage.cpp)
  std::string addItem(Message &message, Type type, unsigned capacity);
  std::string addItem(Message &message, Type type, Value *value);
  void makeArrays(Message &message, SMLoc loc);
  void pack(const Message &message, unsigned item, Value *value);
  Value *unpack(const Message &message, unsigned item);
  void appendOperands(const Message &message, llvm::SmallVectorImpl<Value *> &operands);
  void lowerMethod(const MethodCall &method);

  // Other shaders (LowerCoshader.cpp)
  Value *callCoshader(const CallExpr &call);
  Value *getShader(const CallExpr &call);
  Value *getShaders(const CallExpr &call);
  Value *callMethod(const CallExpr &call);
  Value *parameterName(const Expr *name, const std::string &shape);

  // Arrays whose length changes (LowerArray.cpp)
  static unsigned capacityOf(Value *array);
  Value *lengthOf(Value *array);
  Value *equalArrays(Value *left, Value *right, stc::Op equal);
  void copyLength(Value *to, Value *from);
  void setLength(Value *array, Value *count, llvm::StringRef name, SMLoc loc);
  void warnWhenRun(const llvm::Twine &message, SMLoc loc);
  void warnFull(Value *array, llvm::StringRef name, SMLoc loc);
  Value *callArray(const CallExpr &call);

  // Calls (LowerCall.cpp)
  Value *lowerCall(const CallExpr &call);
  Value *callBuiltin(const CallExpr &call);
  Value *lowerNamed(const CallExpr &call, const BuiltinOperand &operand);
  Value *callFunction(const CallExpr &call);
  bool mayBeTraced(const CallExpr &call) const; // LowerTraced.cpp
  Value *lowerTraced(const CallExpr &call, llvm::ArrayRef<Value *> operands, stc::Op op);
  void lowerTracedShadow(Value *passing, Value *place, llvm::ArrayRef<Value *> cone, SMLoc loc);
  Value *rayField(const CallExpr &call, llvm::StringRef name);
  Value *callComponentWise(const CallExpr &call);
  Value *callSpline(const CallExpr &call); // LowerSpline.cpp
  void chooseBasis(Value *name, llvm::MutableArrayRef<Value *> to);
  Value *callQuery(const CallExpr &call); // LowerQuery.cpp
  Value *query(const stc::QueryKind &kind, Value *subject, Value *name, Type type, Value *variable);
  Value *queryArray(const stc::QueryKind &kind, Value *subject, Value *name, Type type,
                    Value *array);
  Value *callShaderName(const CallExpr &call);
  Value *callFormat(const CallExpr &call); // LowerText.cpp
  Value *callConcat(const CallExpr &call);
  static bool effectsAfter(const CallExpr &call, size_t argument);
  bool hasContext(SMLoc loc);

  /// An operator of a family `name_<representation>`: copy_color, add_vector.
  static stc::Op opFor(TypeKind kind, stc::Op onFloat, stc::Op onColor, stc::Op onVector);
  static stc::Op equality(TypeKind kind);
  static stc::Storage storage(Type type) {
    return type.varying ? stc::Storage::Varying : stc::Storage::Uniform;
  }
  llvm::IRBuilder<> &builder() { return b.ir(); }
  const llvm::IRBuilder<> &builder() const { return const_cast<stc::Builder &>(b).ir(); }

  DiagnosticEngine &diags;
  stc::Builder b;
  SMLoc lastLocation;

  // Of the function being written
  llvm::DenseMap<const VarDecl *, Value *> slots;
  llvm::DenseMap<const OpaqueExpr *, Value *> opaques;
  llvm::DenseMap<Value *, Value *> lengths; ///< of resizable arrays, by their slots
  std::map<unsigned, Value *> globals;      ///< slots of shader globals, by number
  std::map<unsigned, Value *> lightGlobals; ///< inside illuminance: L, Cl and Ol
  std::set<unsigned> writtenGlobals;
  std::set<const VarDecl *> usedParams;
  llvm::StringRef shaderName;
  std::optional<ShaderType> shaderType;    ///< nothing in a library
  const stc::ShaderInfo *initOf = nullptr; ///< set while defaults are computed
  llvm::BasicBlock *bodyBlock = nullptr;
  llvm::BasicBlock *exitBlock = nullptr;

  // Of the function being expanded
  Type resultType;
  Value *resultSlot = nullptr;
  llvm::BasicBlock *returnBlock = nullptr;
  std::vector<Loop> loops;
  CurrentLight currentLight;
  bool isSolar = false; ///< in a light shader: within a `solar` statement
  llvm::DenseMap<const Expr *, Value *> namedValues; ///< of the call being lowered
  unsigned expansions = 0;                           ///< of functions, against those that multiply
};

} // namespace anysl::rsl

#endif
