//===-- anysl/standard/inputs.h - globals and parameters given point by point -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// To be included where a runtime has defined, in an unnamed namespace, where a component lies of
// the globals (step 0: one number serves all points) and, in arrays laid out as
// AnyslShadeArgs::param_data, of an element of parameter `id`, where a type has `components` of
// them:
//
//     anysl_number &number(const anysl_context *, uint32_t component, uint32_t step);
//     template <int components, class Number = anysl_number>
//     Number &inArrays(const anysl_context *, void *const *arrays, uint32_t id, uint32_t element,
//                      int component);
//
// A runtime compiled with ANYSL_READS_HALF takes such arrays as halves, too, parameter by parameter
// as the renderer says.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_INPUTS_H
#define ANYSL_STANDARD_INPUTS_H

#include <anysl/domain.h>

namespace {

anysl_number &globalNumber(const anysl_context *context, uint32_t id, int component) {
  return number(context, anysl::globalComponent[id] + uint32_t(component), anysl::globalStep[id]);
}

/// Component `component` of a place on the surface, or of the way there, to second order; its first
/// derivatives are byU and byV. The turning of the unit normal n says how the surface bends: where
/// a and b are u or v, P_ab . n = -P_a . n_b. What P_ab has along the surface depends on how u and
/// v lie in it, turns no normal, and is left out.
template <typename Real>
Real curved(const anysl_context *context, anysl_number value, anysl_number byU, anysl_number byV,
            int component) {
  using namespace anysl;
  using Triple = Vec<anysl_number>;
  auto triple = [&](const uint32_t &first) {
    return Triple{number(context, first, 1), number(context, first + 1, 1),
                  number(context, first + 2, 1)};
  };
  Triple Pu = triple(anysl_derivative_input_dPdu), Pv = triple(anysl_derivative_input_dPdv);
  Triple N = triple(anysl_derivative_input_N);
  anysl_number inverse = inverseSquareRoot(dot(N, N));
  Triple n = N * inverse;
  auto turning = [&](const Triple &change) { return (change - n * dot(n, change)) * inverse; };
  Triple nu = turning(triple(anysl_derivative_input_dNdu));
  Triple nv = turning(triple(anysl_derivative_input_dNdv));
  auto of = [&](const Triple &x) { return component == 0 ? x.x : component == 1 ? x.y : x.z; };
  return expand<Real>(
      {value, byU, byV, -dot(Pu, nu) * of(n), -dot(Pu, nv) * of(n), -dot(Pv, nv) * of(n)});
}

/// Component `component` of the global `id`, with its derivatives where the real has some.
anysl_float loadGlobal(const anysl_context *context, uint32_t id, int component) {
  using namespace anysl;
  anysl_number value = globalNumber(context, id, component);
  if constexpr (hasDerivatives<anysl_float>) {
    auto derivative = [&](const uint32_t &first) { return number(context, first + component, 1); };
    if constexpr (derivativeOrder<anysl_float> > 1) {
      if (id == ANYSL_P)
        return curved<anysl_float>(context, value, derivative(anysl_derivative_input_dPdu),
                                   derivative(anysl_derivative_input_dPdv), component);
      if (id == ANYSL_I)
        return curved<anysl_float>(context, value, derivative(anysl_derivative_input_dIdu),
                                   derivative(anysl_derivative_input_dIdv), component);
    }
    // The number of a global is a constant of the call, of which one case is left.
    switch (id) {
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  case ANYSL_##name:                                                                               \
    return withDerivatives<anysl_float>(value, derivative(anysl_derivative_input_##byU),           \
                                        derivative(anysl_derivative_input_##byV));
#include <anysl/Globals.def>
    default:
      return withDerivatives<anysl_float>(value, id == ANYSL_u, id == ANYSL_v);
    }
  } else {
    return value;
  }
}

/// Whether the host gave a parameter an array.
bool isWanted(const anysl_context *context, uint32_t id) {
  void *const *data = context->args->param_data;
  return data && data[id];
}

template <int components>
anysl_number &varying(const anysl_context *context, uint32_t id, uint32_t element, int component) {
  return inArrays<components>(context, context->args->param_data, id, element, component);
}

/// What the host gave a parameter.
template <int components>
anysl_number varyingInput(const anysl_context *context, uint32_t id, uint32_t element,
                          int component) {
#ifdef ANYSL_READS_HALF
  const AnyslShadeArgs *args = context->args;
  if (args->param_is_set[id] & ANYSL_PARAM_HALF)
    return anysl::fromHalf(
        inArrays<components, uint16_t>(context, args->param_data, id, element, component));
#endif
  return varying<components>(context, id, element, component);
}

/// A derivative of a parameter given point by point; 0 where the host has none.
template <int components>
anysl_number varyingDerivative(const anysl_context *context, void *const *arrays, uint32_t id,
                               uint32_t element, int component) {
  if (!arrays)
    return 0;
  id = anysl_derivative_param(id);
  return arrays[id] ? inArrays<components>(context, arrays, id, element, component)
                    : anysl_number(0);
}

/// Component `component` of such a parameter, with its derivatives where the real has some.
template <int components>
anysl_float loadVarying(const anysl_context *context, uint32_t id, uint32_t element,
                        int component) {
  using namespace anysl;
  anysl_number value = varyingInput<components>(context, id, element, component);
  if constexpr (hasDerivatives<anysl_float>) {
    const AnyslShadeArgs *args = context->args;
    return withDerivatives<anysl_float>(
        value, varyingDerivative<components>(context, args->param_by_u, id, element, component),
        varyingDerivative<components>(context, args->param_by_v, id, element, component));
  } else {
    return value;
  }
}

} // namespace

#ifdef ANYSL_READS_HALF
const bool anysl_runtime_reads_half = true;
#else
const bool anysl_runtime_reads_half = false;
#endif

// Without derivatives nobody asks, and the linker defines no such places.
anysl_number anysl::stepOfU(const anysl_context *context) {
  if constexpr (hasDerivatives<anysl_float>)
    return number(context, anysl_derivative_input_du, 1);
  return 0;
}
anysl_number anysl::stepOfV(const anysl_context *context) {
  if constexpr (hasDerivatives<anysl_float>)
    return number(context, anysl_derivative_input_dv, 1);
  return 0;
}

//===-- Globals -------------------------------------------------------------------------------===//

void anysl_load_global_float(anysl_float *result, anysl_context *context, uint32_t id) {
  *result = loadGlobal(context, id, 0);
}

void anysl_load_global_color(anysl_color *result, anysl_context *context, uint32_t id) {
  *result = {loadGlobal(context, id, 0), loadGlobal(context, id, 1), loadGlobal(context, id, 2)};
}

void anysl_load_global_vector(anysl_vector *result, anysl_context *context, uint32_t id) {
  *result = {loadGlobal(context, id, 0), loadGlobal(context, id, 1), loadGlobal(context, id, 2)};
}

void anysl_store_global_float(anysl_context *context, uint32_t id, const anysl_float *a) {
  globalNumber(context, id, 0) = numberOf(*a);
}

void anysl_store_global_color(anysl_context *context, uint32_t id, const anysl_color *a) {
  globalNumber(context, id, 0) = numberOf(a->r);
  globalNumber(context, id, 1) = numberOf(a->g);
  globalNumber(context, id, 2) = numberOf(a->b);
}

void anysl_store_global_vector(anysl_context *context, uint32_t id, const anysl_vector *a) {
  globalNumber(context, id, 0) = numberOf(a->x);
  globalNumber(context, id, 1) = numberOf(a->y);
  globalNumber(context, id, 2) = numberOf(a->z);
}

//===-- Parameters ----------------------------------------------------------------------------===//

void anysl_load_varying_float(anysl_float *result, anysl_context *context, uint32_t id,
                              uint32_t element) {
  *result = loadVarying<1>(context, id, element, 0);
}

void anysl_load_varying_color(anysl_color *result, anysl_context *context, uint32_t id,
                              uint32_t element) {
  *result = {loadVarying<3>(context, id, element, 0), loadVarying<3>(context, id, element, 1),
             loadVarying<3>(context, id, element, 2)};
}

void anysl_load_varying_vector(anysl_vector *result, anysl_context *context, uint32_t id,
                               uint32_t element) {
  *result = {loadVarying<3>(context, id, element, 0), loadVarying<3>(context, id, element, 1),
             loadVarying<3>(context, id, element, 2)};
}

void anysl_load_varying_matrix(anysl_matrix *result, anysl_context *context, uint32_t id,
                               uint32_t element) {
  anysl::repeat<16>(
      [&](auto k) { result->m[k / 4][k % 4] = loadVarying<16>(context, id, element, k); });
}

void anysl_store_varying_float(anysl_context *context, uint32_t id, uint32_t element,
                               const anysl_float *a) {
  if (isWanted(context, id))
    varying<1>(context, id, element, 0) = numberOf(*a);
}

void anysl_store_varying_color(anysl_context *context, uint32_t id, uint32_t element,
                               const anysl_color *a) {
  if (!isWanted(context, id))
    return;
  varying<3>(context, id, element, 0) = numberOf(a->r);
  varying<3>(context, id, element, 1) = numberOf(a->g);
  varying<3>(context, id, element, 2) = numberOf(a->b);
}

void anysl_store_varying_vector(anysl_context *context, uint32_t id, uint32_t element,
                                const anysl_vector *a) {
  if (!isWanted(context, id))
    return;
  varying<3>(context, id, element, 0) = numberOf(a->x);
  varying<3>(context, id, element, 1) = numberOf(a->y);
  varying<3>(context, id, element, 2) = numberOf(a->z);
}

void anysl_store_varying_matrix(anysl_context *context, uint32_t id, uint32_t element,
                                const anysl_matrix *a) {
  if (isWanted(context, id))
    anysl::repeat<16>(
        [&](auto k) { varying<16>(context, id, element, k) = numberOf(a->m[k / 4][k % 4]); });
}

/// Texts lie alike in every layout.
void anysl_store_varying_string(anysl_context *context, uint32_t id, uint32_t element,
                                const anysl_string *a) {
  if (!isWanted(context, id))
    return;
  auto *texts = static_cast<anysl_string *>(context->args->param_data[id]);
  texts[size_t(element) * context->args->data_stride + context->point] = *a;
}

#endif // ANYSL_STANDARD_INPUTS_H
