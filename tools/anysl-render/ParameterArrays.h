//===-- tools/anysl-render/ParameterArrays.h - parameters point by point ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_PARAMETERARRAYS_H
#define ANYSL_RENDER_PARAMETERARRAYS_H

#include "tools/anysl-render/Host.h"

#include <algorithm>

namespace anysl::render {

/// The values of a shader's parameters that differ from point to point: those that come from
/// variables of the surface, and outputs.
template <typename Real>
class ParameterArrays {
public:
  /// Room for `stride` points, with outputs where the shader is asked for them: those that a
  /// picture shows, and all where another shader may ask.
  ParameterArrays(Arena &arena, const Shader &shader, std::span<const Binding> bound,
                  bool withOutputs, bool allOutputs, AnyslLayout layout, size_t stride)
      : shader(shader), bound(bound), layout(layout), stride(stride) {
    if (bound.empty() && !allOutputs && !(withOutputs && !shader.outputs.empty()))
      return;
    arrays = arena.allocate<void *>(shader.info->param_count);
    std::fill_n(arrays, shader.info->param_count, nullptr);
    AnyslShadeArgs args;
    anysl_instance_fill_args(shader.instance.get(), &args);
    for (uint32_t p = 0; p < shader.info->param_count; ++p) {
      const AnyslParamInfo &param = shader.info->params[p];
      bool isShown = withOutputs && std::any_of(shader.outputs.begin(), shader.outputs.end(),
                                                [&](const auto &each) { return each.param == p; });
      if (!isShown && !(allOutputs && (param.flags & ANYSL_PARAM_OUTPUT)))
        continue;
      // One that the shader never assigns has the parameter's value.
      uint32_t components = anysl_type_components(param.type);
      uint32_t numbers = components * (param.array_length ? param.array_length : 1);
      if (param.type == ANYSL_STRING) {
        auto *texts = arena.allocate<const char *>(numbers * stride);
        for (size_t i = 0; i < numbers * stride; ++i)
          texts[i] = args.params[param.first_cell + i / stride].string;
        arrays[p] = texts;
        continue;
      }
      arrays[p] = arena.allocate<Real>(numbers * stride);
      for (uint32_t k = 0; k < numbers; ++k)
        for (size_t i = 0; i < stride; ++i)
          at(p, components, k, i) = Real(args.params[param.first_cell + k].number);
    }
    uint32_t most = 0;
    for (const Binding &binding : bound) {
      if (!arrays[binding.parameter])
        arrays[binding.parameter] = arena.allocate<Real>(binding.numbers * stride);
      std::fill_n(static_cast<Real *>(arrays[binding.parameter]), binding.numbers * stride,
                  Real(0));
      most = std::max(most, binding.numbers);
    }
    scratch = arena.allocate<float>(most);
  }

  /// Sets the values of point i from the variables of the surface that was hit there.
  template <typename Interpolate>
  void set(size_t i, std::span<const Binding> itsBindings, const Interpolate &interpolate) {
    for (const Binding &binding : itsBindings) {
      interpolate(binding.variable, scratch);
      uint32_t components = anysl_type_components(shader.info->params[binding.parameter].type);
      for (uint32_t k = 0; k < binding.numbers; ++k)
        at(binding.parameter, components, k, i) = Real(scratch[k]);
    }
  }

  /// The number k of an output at point i.
  Real output(const Shader::Output &output, uint32_t k, size_t i) const {
    return at(output.param, anysl_type_components(shader.info->params[output.param].type), k, i);
  }

  void fill(AnyslShadeArgs &args) const {
    if (!arrays)
      return;
    args.param_data = arrays;
    args.data_stride = stride;
  }

private:
  Real &at(uint32_t parameter, uint32_t components, uint32_t k, size_t i) const {
    auto *numbers = static_cast<Real *>(arrays[parameter]);
    if (layout == ANYSL_LAYOUT_SOA)
      return numbers[k * stride + i];
    return numbers[(k / components * stride + i) * components + k % components];
  }

  const Shader &shader;
  std::span<const Binding> bound;
  AnyslLayout layout;
  size_t stride;
  void **arrays = nullptr; ///< of Real; of text, which is of one component, const char *
  float *scratch = nullptr;
};

} // namespace anysl::render

#endif
