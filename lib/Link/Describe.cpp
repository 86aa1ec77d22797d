//===-- lib/Link/Describe.cpp - writes the library's descriptor ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// `anysl_library`, an AnyslLibraryInfo of <anysl/abi.h> as constant data. The structures are spelt
// here as LLVM types; that their sizes are those of the C header is checked when they are made.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/SceneLights.h"
#include "lib/Support/Tool.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/xxhash.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Transforms/IPO/Internalize.h"
#include <anysl/abi.h>
#include <anysl/demand.h>
#include <anysl/notes.h>

using namespace llvm;

namespace anysl::link {
namespace {

class Descriptor {
public:
  explicit Descriptor(Session &session)
      : session(session), module(*session.module), builder(session.context) {}

  void build() {
    SmallVector<Constant *> shaders;
    for (const Shader &shader : session.shaders)
      shaders.push_back(shaderInfo(shader));
    Constant *info =
        structure(sizeof(AnyslLibraryInfo),
                  {u32(ANYSL_MAGIC), u32(ANYSL_ABI_VERSION), u32(sizeof(AnyslLibraryInfo)),
                   fact("anysl_runtime_layout"), fact("anysl_real_format"), u32(ANYSL_GLOBAL_COUNT),
                   u32(ANYSL_COMPONENT_COUNT), u32(sizeof(AnyslShadeArgs)),
                   u32(sizeof(AnyslServices)), u32(unsigned(shaders.size())), array(shaders),
                   text("AnySL " ANYSL_VERSION), text(session.options.runtime), text(session.real),
                   text(session.math.text()), text(session.target.getTargetCPU()),
                   text(cpuFeatures(session.target)), fact("anysl_runtime_reads_half"), u32(0)});
    auto *library = new GlobalVariable(module, info->getType(), /*isConstant=*/true,
                                       GlobalValue::ExternalLinkage, info, ANYSL_LIBRARY_SYMBOL);
    library->setAlignment(Align(8));
    if (session.options.scene)
      describeDemand(*session.options.scene);
  }

private:
  /// What the scene was, for hosts that have another (<anysl/demand.h>).
  void describeDemand(const demand::Demand &scene) {
    std::string manifest = demand::writeManifest(scene, /*places=*/false);
    SmallSetVector<StringRef, 8> dropped;
    for (const Shader &shader : session.shaders)
      for (const std::string &name : shader.report.droppedOutputs)
        dropped.insert(name);
    Constant *time =
        ConstantFP::get(builder.getDoubleTy(), scene.shutter ? (*scene.shutter)[0] : 0);
    SmallVector<Constant *> sources;
    for (const Shader &shader : session.shaders)
      sources.push_back(
          structure(sizeof(AnyslSourceInfo), {u64(shader.sourceWritten), u32(shader.sourceEffects),
                                              u32(shader.keepsOpacity)}));
    SmallVector<Constant *> lights, params;
    if (!session.report.linkedLights.empty())
      for (auto [number, its] : enumerate(linkedLights(session))) {
        demand::LightDemand light = its;
        if (number < session.lightCode.size() && session.lightCode[number].isCalled) {
          light.values.known |= ANYSL_KNOWN_CODE;
          light.values.light.code = session.lightCode[number].code;
          for (const LightCell &cell : session.lightCode[number].fixed)
            params.push_back(linkedParam(unsigned(number), cell));
        }
        lights.push_back(checked(sizeof(AnyslLinkedLight), lightConstant(module, light)));
      }
    std::array<float, 3> ambient{};
    if (session.linksAmbient)
      ambient = *linkedAmbient(session);
    SmallVector<Constant *> globals;
    for (const auto &[global, value] : session.fixedGlobals)
      globals.push_back(structure(
          sizeof(AnyslFixedGlobal),
          {u32(global), u32(0), ConstantDataArray::get(session.context, ArrayRef(value))}));
    Constant *info = structure(
        sizeof(AnyslDemandInfo),
        {u32(sizeof(AnyslDemandInfo)), u32(scene.assumptions()), u64(xxh3_64bits(manifest)),
         text(manifest), text(join(dropped, ",")), time, array(sources), array(lights),
         u32(unsigned(lights.size())), u32(session.linksAmbient),
         ConstantDataArray::get(session.context, ArrayRef(ambient)), u32(unsigned(globals.size())),
         array(globals), array(params), u32(unsigned(params.size())), u32(0)});
    auto *variable = new GlobalVariable(module, info->getType(), /*isConstant=*/true,
                                        GlobalValue::ExternalLinkage, info, ANYSL_DEMAND_SYMBOL);
    variable->setAlignment(Align(8));
  }

  Constant *linkedParam(unsigned light, const LightCell &cell) {
    return structure(sizeof(AnyslLinkedParam),
                     {u32(light), u32(cell.cell), text(cell.name),
                      cell.text ? text(*cell.text) : ConstantPointerNull::get(builder.getPtrTy()),
                      ConstantFP::get(builder.getDoubleTy(), cell.number)});
  }

  Constant *u32(uint32_t value) { return builder.getInt32(value); }
  Constant *u64(uint64_t value) { return builder.getInt64(value); }

  Constant *text(StringRef value) {
    auto *data = ConstantDataArray::getString(session.context, value);
    auto *global = new GlobalVariable(module, data->getType(), true, GlobalValue::PrivateLinkage,
                                      data, "anysl.text");
    global->setUnnamedAddr(GlobalValue::UnnamedAddr::Global);
    global->setAlignment(Align(1));
    return global;
  }

  /// A structure that must have the size of its counterpart in C.
  Constant *structure(size_t size, ArrayRef<Constant *> fields) {
    return checked(size, ConstantStruct::getAnon(session.context, fields));
  }

  Constant *checked(size_t size, Constant *value) {
    if (module.getDataLayout().getTypeAllocSize(value->getType()) != size)
      reportInternalError("the descriptor does not match <anysl/abi.h>");
    return value;
  }

  /// Points to the elements; null if there are none.
  Constant *array(ArrayRef<Constant *> elements) {
    if (elements.empty())
      return ConstantPointerNull::get(builder.getPtrTy());
    auto *type = ArrayType::get(elements[0]->getType(), elements.size());
    return new GlobalVariable(module, type, true, GlobalValue::PrivateLinkage,
                              ConstantArray::get(type, elements), "anysl.table");
  }

  /// What the runtime or the real says of itself; the linker has asked for it, so it is there.
  Constant *fact(StringRef name) {
    auto value = constantOf(module, name);
    if (!value)
      reportInternalError("runtime '" + session.options.runtime + "' with real '" + session.real +
                          "' does not define '" + name + "'");
    return u32(uint32_t(*value));
  }

  Constant *paramInfo(const stc::ParamInfo &param, bool fixed, bool differentiated) {
    uint32_t flags = (param.storage == stc::Storage::Varying ? ANYSL_PARAM_VARYING : 0) |
                     (param.output ? ANYSL_PARAM_OUTPUT : 0) | (fixed ? ANYSL_PARAM_FIXED : 0) |
                     (differentiated ? ANYSL_PARAM_DIFFERENTIATED : 0);
    return structure(sizeof(AnyslParamInfo),
                     {text(param.name), u32(uint32_t(param.type)), u32(flags),
                      u32(param.arrayLength), u32(param.firstCell)});
  }

  Constant *shaderInfo(const Shader &shader) {
    SmallVector<Constant *> params, entries;
    for (unsigned i = 0; i < shader.info.params.size(); ++i)
      params.push_back(paramInfo(shader.info.params[i], shader.fixed[i],
                                 i < shader.differentiated.size() && shader.differentiated[i]));
    for (const Entry &entry : shader.entries)
      entries.push_back(structure(sizeof(AnyslEntryInfo), {u32(entry.width), entry.function}));
    uint64_t read = 0, written = 0;
    for (const stc::GlobalInfo &global : shader.info.globals) {
      read |= uint64_t(global.read) << global.id;
      written |= uint64_t(global.written) << global.id;
    }
    return structure(sizeof(AnyslShaderInfo),
                     {text(shader.info.name), u32(uint32_t(shader.info.kind)),
                      u32(unsigned(params.size())), array(params), u32(shader.info.cellCount()),
                      u32(unsigned(entries.size())), array(entries), u64(read), u64(written),
                      u32(shader.services), u32(shader.effects), shader.init, u64(shader.code)});
  }

  Session &session;
  Module &module;
  IRBuilder<> builder;
};

} // namespace

bool describe(Session &session) {
  Descriptor(session).build();
  internalizeModule(*session.module, [](const GlobalValue &value) {
    return value.getName() == ANYSL_LIBRARY_SYMBOL || value.getName() == ANYSL_NOTES_SYMBOL ||
           value.getName() == ANYSL_DEMAND_SYMBOL;
  });
  return true;
}

} // namespace anysl::link
