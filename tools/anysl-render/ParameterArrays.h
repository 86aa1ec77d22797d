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
          at(arrays, p, components, k, i) = Real(args.params[param.first_cell + k].number);
    }
    uint32_t most = 0;
    for (const Binding &binding : bound) {
      clear(arena, arrays, binding);
      most = std::max(most, binding.numbers);
      if (isDifferentiated(binding))
        for (void **&derivatives : slopes) {
          if (!derivatives) {
            derivatives = arena.allocate<void *>(shader.info->param_count);
            std::fill_n(derivatives, shader.info->param_count, nullptr);
          }
          clear(arena, derivatives, binding);
        }
    }
    scratch = arena.allocate<float>(most);
  }

  /// Sets the values of point i from the variables of the surface that was hit there.
  void set(size_t i, std::span<const Binding> itsBindings, const VariablesAt &variables) {
    for (const Binding &binding : itsBindings) {
      variables.value(binding.variable, scratch);
      uint32_t components = anysl_type_components(shader.info->params[binding.parameter].type);
      for (uint32_t k = 0; k < binding.numbers; ++k)
        at(arrays, binding.parameter, components, k, i) = Real(scratch[k]);
      for (uint32_t k = 0; k < binding.numbers && isDifferentiated(binding); ++k) {
        double byU, byV;
        variables.slope(binding.variable, k, byU, byV);
        at(slopes[0], binding.parameter, components, k, i) = Real(byU);
        at(slopes[1], binding.parameter, components, k, i) = Real(byV);
      }
    }
  }

  /// The number k of an output at point i.
  Real output(const Shader::Output &output, uint32_t k, size_t i) const {
    return at(arrays, output.param, anysl_type_components(shader.info->params[output.param].type),
              k, i);
  }

  /// Element k of an output that is text, at point i.
  const char *text(uint32_t parameter, uint32_t k, size_t i) const {
    return static_cast<const char **>(arrays[parameter])[k * stride + i];
  }

  void fill(AnyslShadeArgs &args) const {
    if (!arrays)
      return;
    args.param_data = arrays;
    args.param_by_u = slopes[0];
    args.param_by_v = slopes[1];
    args.data_stride = stride;
  }

private:
  bool isDifferentiated(const Binding &binding) const {
    return (shader.info->params[binding.parameter].flags & ANYSL_PARAM_DIFFERENTIATED) != 0;
  }
  /// Zeros for the points that have another surface's variables.
  void clear(Arena &arena, void **all, const Binding &binding) {
    if (!all[binding.parameter])
      all[binding.parameter] = arena.allocate<Real>(binding.numbers * stride);
    std::fill_n(static_cast<Real *>(all[binding.parameter]), binding.numbers * stride, Real(0));
  }
  Real &at(void *const *all, uint32_t parameter, uint32_t components, uint32_t k, size_t i) const {
    auto *numbers = static_cast<Real *>(all[parameter]);
    if (layout == ANYSL_LAYOUT_SOA)
      return numbers[k * stride + i];
    return numbers[(k / components * stride + i) * components + k % components];
  }

  const Shader &shader;
  std::span<const Binding> bound;
  AnyslLayout layout;
  size_t stride;
  void **arrays = nullptr; ///< of Real; of text, which is of one component, const char *
  void **slopes[2] = {};   ///< how the numbers change with u, with v; null: nobody reads that
  float *scratch = nullptr;
};

} // namespace anysl::render

#endif
