//===-- lib/Host/Batch.cpp - points to shade, in a library's own layout -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The host sees points as tuples of float or double; the library wants arrays of its own format in
// one of two layouts. AnyslView describes both by strides, so that copying is one loop for all.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Half.h"
#include "lib/Host/Internal.h"
#include <algorithm>

using namespace anysl::host;

namespace {

constexpr uint32_t padding = 16; // points: the widest entry may read that far

constexpr int firstComponents[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_COMPONENT_##name,
#include <anysl/Globals.def>
};

uint32_t roundUp(uint32_t points) { return (points + padding - 1) / padding * padding; }

size_t realSize(const AnyslLibraryInfo &info) {
  return info.real == ANYSL_REAL_DOUBLE ? sizeof(double) : sizeof(float);
}

void placeGlobalsSoA(AnyslBatch &batch, size_t real) {
  size_t reals = 0;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if (batch.globals >> global & 1)
      reals += anysl_global_components(global) *
               (anysl_global_is_uniform(global) ? padding : batch.stride);
  batch.globalData = AlignedBuffer(reals * real);
  batch.globalPointers.resize(ANYSL_COMPONENT_COUNT);
  char *next = batch.globalData.get();
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global) {
    if (!(batch.globals >> global & 1))
      continue;
    bool uniform = anysl_global_is_uniform(global);
    size_t component = uniform ? padding : batch.stride;
    batch.globalViews[global] = {next, 0, component, size_t(!uniform)};
    for (uint32_t c = 0; c < anysl_global_components(global); ++c, next += component * real)
      batch.globalPointers[firstComponents[global] + c] = next;
  }
}

void placeGlobalsAoS(AnyslBatch &batch, size_t real) {
  batch.globalData = AlignedBuffer(roundUp(batch.capacity) * size_t(ANYSL_COMPONENT_COUNT) * real);
  batch.globalPointers = {batch.globalData.get()};
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if (batch.globals >> global & 1)
      batch.globalViews[global] = {batch.globalData.get() + firstComponents[global] * real, 0, 1,
                                   ANYSL_COMPONENT_COUNT};
}

/// How a parameter's values, or derivatives, lie that begin at `base`.
AnyslView paramView(const AnyslBatch &batch, int index, char *base) {
  size_t components = anysl_type_components(batch.shader->params[index].type);
  if (batch.library->info->layout == ANYSL_LAYOUT_SOA)
    return {base, components * batch.stride, batch.stride, 1};
  return {base, components * batch.stride, 1, components};
}

struct Range {
  uint32_t elements, components;
  uint32_t first, count;
};

template <class Real, class Value>
void copyIn(const AnyslView &view, Range range, const Value *values, size_t stride) {
  for (uint32_t i = 0; i < range.count; ++i, values += stride)
    for (uint32_t e = 0; e < range.elements; ++e)
      for (uint32_t c = 0; c < range.components; ++c)
        reinterpret_cast<Real *>(view.base)[e * view.element + c * view.component +
                                            (size_t(range.first) + i) * view.point] =
            Real(values[e * range.components + c]);
}

template <class Real, class Value>
void copyOut(const AnyslView &view, Range range, Value *values, size_t stride) {
  for (uint32_t i = 0; i < range.count; ++i, values += stride)
    for (uint32_t e = 0; e < range.elements; ++e)
      for (uint32_t c = 0; c < range.components; ++c)
        values[e * range.components + c] = Value(
            reinterpret_cast<const Real *>(view.base)[e * view.element + c * view.component +
                                                      (size_t(range.first) + i) * view.point]);
}

template <class Value>
void copyIn(const AnyslBatch &batch, const AnyslView &view, Range range, const Value *values,
            size_t stride) {
  if (batch.library->info->real == ANYSL_REAL_DOUBLE)
    copyIn<double>(view, range, values, stride);
  else
    copyIn<float>(view, range, values, stride);
}

template <class Value>
void copyOut(const AnyslBatch &batch, const AnyslView &view, Range range, Value *values,
             size_t stride) {
  if (batch.library->info->real == ANYSL_REAL_DOUBLE)
    copyOut<double>(view, range, values, stride);
  else
    copyOut<float>(view, range, values, stride);
}

AnyslStatus checkRange(const AnyslBatch &batch, uint32_t first, uint32_t count) {
  if (uint64_t(first) + count <= batch.capacity)
    return ANYSL_OK;
  return fail(ANYSL_ERROR_RANGE, context(*batch.library, *batch.shader) + "points " +
                                     std::to_string(first) + " to " +
                                     std::to_string(uint64_t(first) + count) +
                                     " are outside a batch of " + std::to_string(batch.capacity));
}

AnyslStatus noSuchGlobal(const AnyslBatch &batch, int global) {
  const char *name = anysl_global_name(global);
  std::string problem = name ? std::string("the batch has no room for the global '") + name +
                                   "', which the shader does not use"
                             : "there is no global number " + std::to_string(global);
  return fail(ANYSL_ERROR_NAME, context(*batch.library, *batch.shader) + problem);
}

/// Fails if a global is to be something else than what a library was linked for.
template <class Value>
AnyslStatus checkFixed(const AnyslBatch &batch, int global, uint32_t count, const Value *values,
                       size_t stride) {
  const AnyslFixedGlobal *fixed = fixedGlobal(*batch.library, global);
  if (!fixed || batch.shader->kind != ANYSL_SURFACE)
    return ANYSL_OK;
  bool isDouble = batch.library->info->real == ANYSL_REAL_DOUBLE;
  auto rounded = [&](double x) { return isDouble ? x : double(float(x)); };
  for (uint32_t i = 0; i < count; ++i)
    for (size_t c = 0; c < 3; ++c)
      if (rounded(double(values[i * stride + c])) != rounded(fixed->value[c]))
        return fail(ANYSL_ERROR_STATE, context(*batch.library, *batch.shader) +
                                           "the library was linked for a scene where '" +
                                           anysl_global_name(global) +
                                           "' is the same everywhere, and here it is another");
  return ANYSL_OK;
}

template <class Value>
AnyslStatus writeGlobal(AnyslBatch &batch, int global, uint32_t first, uint32_t count,
                        const Value *values, size_t stride) {
  if (!anysl_global_name(global))
    return noSuchGlobal(batch, global);
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  if (AnyslStatus status = checkFixed(batch, global, count, values, stride))
    return status;
  if (!(batch.globals >> global & 1) || !count)
    return ANYSL_OK;
  Range range = {1, anysl_global_components(global), first, count};
  if (anysl_global_is_uniform(global)) {
    // One value in an SoA batch; in an AoS batch every point has its copy.
    bool everyPoint = batch.globalViews[global].point;
    range.first = 0;
    range.count = everyPoint ? roundUp(batch.capacity) : 1;
    stride = 0;
  }
  copyIn(batch, batch.globalViews[global], range, values, stride);
  return ANYSL_OK;
}

template <class Value>
AnyslStatus readGlobal(const AnyslBatch &batch, int global, uint32_t first, uint32_t count,
                       Value *values, size_t stride) {
  if (!anysl_global_name(global) || !(batch.globals >> global & 1))
    return noSuchGlobal(batch, global);
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  copyOut(batch, batch.globalViews[global], {1, anysl_global_components(global), first, count},
          values, stride);
  return ANYSL_OK;
}

/// Finds a parameter and gives it an array, if possible of halves where those are wanted; \p flag
/// says which kind of parameter it has to be.
AnyslStatus provideParam(AnyslBatch &batch, const char *name, uint32_t flag, int &index,
                         bool wantsHalves = false) {
  index = findParam(*batch.library, *batch.shader, name);
  if (index < 0)
    return ANYSL_ERROR_NAME;
  const AnyslParamInfo &param = batch.shader->params[index];
  bool output = flag == ANYSL_PARAM_OUTPUT;
  if (!(param.flags & flag) || (param.type == ANYSL_STRING && !output))
    return fail(ANYSL_ERROR_TYPE,
                context(*batch.library, *batch.shader) + "parameter '" + name + "' is " +
                    (param.type == ANYSL_STRING ? "text, which has no values point by point"
                     : output                   ? "not an output parameter"
                                                : "uniform"));
  if (!batch.paramBuffers[index].get()) {
    bool halves =
        wantsHalves && batch.library->info->reads_half && !(param.flags & ANYSL_PARAM_OUTPUT);
    size_t size = param.type == ANYSL_STRING ? sizeof(char *)
                  : halves                   ? sizeof(Half)
                                             : realSize(*batch.library->info);
    batch.paramBuffers[index] = AlignedBuffer(size_t(cellsOf(param)) * batch.stride * size);
    batch.paramFlags[index] = output ? ANYSL_PARAM_ONLY_OUT : halves ? ANYSL_PARAM_HALF : 0;
    batch.paramPointers[index] = batch.paramBuffers[index].get();
    batch.args.param_data = batch.paramPointers.data();
    batch.args.data_stride = batch.stride;
  }
  return ANYSL_OK;
}

Range paramRange(const AnyslParamInfo &param, uint32_t first, uint32_t count) {
  return {param.array_length ? param.array_length : 1, anysl_type_components(param.type), first,
          count};
}

/// Makes an array of halves one of the library's reals.
void widenHalves(AnyslBatch &batch, int index) {
  size_t values = size_t(cellsOf(batch.shader->params[index])) * batch.stride;
  AlignedBuffer halves = std::move(batch.paramBuffers[index]);
  batch.paramBuffers[index] = AlignedBuffer(values * realSize(*batch.library->info));
  batch.paramPointers[index] = batch.paramBuffers[index].get();
  batch.paramFlags[index] = 0;
  auto all = uint32_t(values);
  copyIn(batch, {batch.paramBuffers[index].get(), 0, 0, 1}, {1, 1, 0, all},
         reinterpret_cast<const Half *>(halves.get()), 1);
}

template <class Value>
AnyslStatus bindParam(AnyslBatch &batch, const char *name, uint32_t first, uint32_t count,
                      const Value *values, size_t stride) {
  constexpr bool fromHalves = std::is_same_v<Value, Half>;
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  int index;
  if (AnyslStatus status = provideParam(batch, name, ANYSL_PARAM_VARYING, index, fromHalves))
    return status;
  if (batch.paramFlags[index] & ANYSL_PARAM_HALF && !fromHalves)
    widenHalves(batch, index);
  batch.paramFlags[index] &= ANYSL_PARAM_HALF;
  AnyslView view = paramView(batch, index, batch.paramBuffers[index].get());
  Range range = paramRange(batch.shader->params[index], first, count);
  if constexpr (fromHalves)
    if (batch.paramFlags[index]) {
      copyIn<Half>(view, range, values, stride);
      return ANYSL_OK;
    }
  copyIn(batch, view, range, values, stride);
  return ANYSL_OK;
}

template <class Value>
AnyslStatus bindDerivatives(AnyslBatch &batch, const char *name, uint32_t first, uint32_t count,
                            const Value *byU, const Value *byV, size_t stride) {
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  int index = findParam(*batch.library, *batch.shader, name);
  if (index < 0)
    return ANYSL_ERROR_NAME;
  if (!batch.paramBuffers[index].get() || batch.paramFlags[index] & ANYSL_PARAM_ONLY_OUT)
    return fail(ANYSL_ERROR_STATE, context(*batch.library, *batch.shader) + "parameter '" + name +
                                       "' has no values point by point that could change");
  const AnyslParamInfo &param = batch.shader->params[index];
  if (!(param.flags & ANYSL_PARAM_DIFFERENTIATED))
    return ANYSL_OK;
  auto copy = [&](AnyslBatch::Derivatives &to, void *const *&place, const Value *values) {
    to.buffers.resize(batch.shader->param_count);
    to.pointers.resize(batch.shader->param_count);
    AlignedBuffer &buffer = to.buffers[index];
    if (!buffer.get())
      buffer = AlignedBuffer(cellsOf(param) * batch.stride * realSize(*batch.library->info));
    to.pointers[index] = buffer.get();
    place = to.pointers.data();
    copyIn(batch, paramView(batch, index, buffer.get()), paramRange(param, first, count), values,
           stride);
  };
  copy(batch.byU, batch.args.param_by_u, byU);
  copy(batch.byV, batch.args.param_by_v, byV);
  return ANYSL_OK;
}

/// Finds an output parameter that was asked for.
AnyslStatus findOutput(const AnyslBatch &batch, const char *name, bool text, int &index) {
  index = findParam(*batch.library, *batch.shader, name);
  if (index < 0)
    return ANYSL_ERROR_NAME;
  if (!batch.paramBuffers[index].get())
    return fail(ANYSL_ERROR_STATE, context(*batch.library, *batch.shader) + "output parameter '" +
                                       name + "' was not asked for before shading");
  if ((batch.shader->params[index].type == ANYSL_STRING) != text)
    return fail(ANYSL_ERROR_TYPE, context(*batch.library, *batch.shader) + "output parameter '" +
                                      name + "' is " + (text ? "not text" : "text"));
  return ANYSL_OK;
}

AnyslStatus readTexts(const AnyslBatch &batch, const char *name, uint32_t first, uint32_t count,
                      const char **values, size_t stride) {
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  int index;
  if (AnyslStatus status = findOutput(batch, name, true, index))
    return status;
  auto *texts = reinterpret_cast<const char *const *>(batch.paramBuffers[index].get());
  for (uint32_t i = 0; i < count; ++i)
    for (uint32_t e = 0; e < cellsOf(batch.shader->params[index]); ++e) {
      const char *text = texts[e * batch.stride + first + i];
      values[i * stride + e] = text ? text : "";
    }
  return ANYSL_OK;
}

template <class Value>
AnyslStatus readOutput(const AnyslBatch &batch, const char *name, uint32_t first, uint32_t count,
                       Value *values, size_t stride) {
  if (AnyslStatus status = checkRange(batch, first, count))
    return status;
  int index;
  if (AnyslStatus status = findOutput(batch, name, false, index))
    return status;
  copyOut(batch, paramView(batch, index, batch.paramBuffers[index].get()),
          paramRange(batch.shader->params[index], first, count), values, stride);
  return ANYSL_OK;
}

AnyslStatus create(const AnyslInstance &instance, uint32_t capacity, uint64_t moreGlobals,
                   AnyslBatch **result) {
  const AnyslLibraryInfo &info = *instance.library->info;
  if (!capacity || capacity > UINT32_MAX - 2 * padding)
    return fail(ANYSL_ERROR_RANGE, context(*instance.library, *instance.shader) + "a batch of " +
                                       std::to_string(capacity) + " points is not possible");
  auto batch = std::make_unique<AnyslBatch>();
  batch->library = instance.library;
  batch->shader = instance.shader;
  batch->capacity = capacity;
  // A cache line more than needed: component arrays that are a power of two apart would all fall
  // into the same sets of the cache.
  batch->stride = size_t(roundUp(capacity)) + padding;
  batch->globals =
      (instance.shader->globals_read | instance.shader->globals_written | moreGlobals) &
      ((uint64_t(1) << ANYSL_GLOBAL_COUNT) - 1);
  batch->globalViews.resize(ANYSL_GLOBAL_COUNT);
  if (info.layout == ANYSL_LAYOUT_SOA)
    placeGlobalsSoA(*batch, realSize(info));
  else
    placeGlobalsAoS(*batch, realSize(info));
  batch->paramBuffers.resize(instance.shader->param_count);
  batch->paramPointers.resize(instance.shader->param_count);
  batch->paramFlags.resize(instance.shader->param_count + 1);
  batch->args.struct_size = sizeof(AnyslShadeArgs);
  batch->args.count = capacity;
  batch->args.globals = batch->globalPointers.data();
  batch->args.param_is_set = batch->paramFlags.data();
  *result = batch.release();
  return ANYSL_OK;
}

AnyslStatus shade(const AnyslInstance &instance, const AnyslBatch &batch, uint32_t first,
                  uint32_t last, uint32_t width) {
  if (instance.shader != batch.shader)
    return fail(ANYSL_ERROR_STATE, context(*instance.library, *instance.shader) +
                                       "the batch was made for shader '" + batch.shader->name +
                                       "' of " + batch.library->path);
  if (first > last || last > batch.args.count)
    return fail(ANYSL_ERROR_RANGE, context(*instance.library, *instance.shader) + "points " +
                                       std::to_string(first) + " to " + std::to_string(last) +
                                       " are outside a batch of " +
                                       std::to_string(batch.args.count));
  AnyslShadeFunction entry = anysl_shader_entry(instance.shader, width);
  if (!entry) {
    std::string widths;
    for (uint32_t i = 0; i < instance.shader->entry_count; ++i)
      widths += (i ? ", " : "") + std::to_string(instance.shader->entries[i].width);
    return fail(ANYSL_ERROR_RANGE, context(*instance.library, *instance.shader) +
                                       "no code for width " + std::to_string(width) + "; it has " +
                                       widths);
  }
  if (AnyslStatus status = checkLights(*instance.library, batch.args.lights, batch.args.light_count,
                                       batch.args.ambient))
    return status;
  // A copy, so that threads can shade different ranges of one batch.
  AnyslShadeArgs args = batch.args;
  args.params = const_cast<AnyslCell *>(instance.cells.data());
  args.services = &instance.services;
  args.renderer = instance.renderer;
  args.library = instance.library->info;
  args.globals_given = batch.globals;
  // Without light shaders there is nothing to keep.
  bool keep = std::any_of(args.lights, args.lights + args.light_count,
                          [](const AnyslLight &light) { return light.kind == ANYSL_LIGHT_SHADER; });
  if (keep)
    anysl_lights_begin(&args);
  entry(&args, first, last);
  if (keep)
    anysl_lights_end(&args);
  return ANYSL_OK;
}

} // namespace

extern "C" {

AnyslStatus anysl_batch_create(const AnyslInstance *instance, uint32_t capacity,
                               uint64_t more_globals, AnyslBatch **batch) {
  return guarded([&] { return create(*instance, capacity, more_globals, batch); });
}

void anysl_batch_free(AnyslBatch *batch) { delete batch; }
uint64_t anysl_batch_globals(const AnyslBatch *batch) { return batch->globals; }
uint32_t anysl_batch_count(const AnyslBatch *batch) { return batch->args.count; }

AnyslStatus anysl_batch_set_count(AnyslBatch *batch, uint32_t count) {
  return guarded([&] {
    AnyslStatus status = checkRange(*batch, 0, count);
    if (!status)
      batch->args.count = count;
    return status;
  });
}

AnyslStatus anysl_batch_write_float(AnyslBatch *batch, int global, uint32_t first, uint32_t count,
                                    const float *values, size_t stride) {
  return guarded([&] { return writeGlobal(*batch, global, first, count, values, stride); });
}

AnyslStatus anysl_batch_write_double(AnyslBatch *batch, int global, uint32_t first, uint32_t count,
                                     const double *values, size_t stride) {
  return guarded([&] { return writeGlobal(*batch, global, first, count, values, stride); });
}

AnyslStatus anysl_batch_read_float(const AnyslBatch *batch, int global, uint32_t first,
                                   uint32_t count, float *values, size_t stride) {
  return guarded([&] { return readGlobal(*batch, global, first, count, values, stride); });
}

AnyslStatus anysl_batch_read_double(const AnyslBatch *batch, int global, uint32_t first,
                                    uint32_t count, double *values, size_t stride) {
  return guarded([&] { return readGlobal(*batch, global, first, count, values, stride); });
}

void *anysl_batch_global(AnyslBatch *batch, int global, uint32_t component, size_t *stride) {
  if (component >= anysl_global_components(global) || !batch->globalViews[global].base)
    return nullptr;
  const AnyslView &view = batch->globalViews[global];
  if (stride)
    *stride = view.point;
  return view.base + component * view.component * realSize(*batch->library->info);
}

AnyslStatus anysl_batch_bind_float(AnyslBatch *batch, const char *param, uint32_t first,
                                   uint32_t count, const float *values, size_t stride) {
  return guarded([&] { return bindParam(*batch, param, first, count, values, stride); });
}

AnyslStatus anysl_batch_bind_double(AnyslBatch *batch, const char *param, uint32_t first,
                                    uint32_t count, const double *values, size_t stride) {
  return guarded([&] { return bindParam(*batch, param, first, count, values, stride); });
}

AnyslStatus anysl_batch_bind_half(AnyslBatch *batch, const char *param, uint32_t first,
                                  uint32_t count, const uint16_t *values, size_t stride) {
  auto *halves = reinterpret_cast<const Half *>(values);
  return guarded([&] { return bindParam(*batch, param, first, count, halves, stride); });
}

AnyslStatus anysl_batch_bind_derivatives_float(AnyslBatch *batch, const char *param, uint32_t first,
                                               uint32_t count, const float *by_u, const float *by_v,
                                               size_t stride) {
  return guarded([&] { return bindDerivatives(*batch, param, first, count, by_u, by_v, stride); });
}

AnyslStatus anysl_batch_bind_derivatives_double(AnyslBatch *batch, const char *param,
                                                uint32_t first, uint32_t count, const double *by_u,
                                                const double *by_v, size_t stride) {
  return guarded([&] { return bindDerivatives(*batch, param, first, count, by_u, by_v, stride); });
}

AnyslStatus anysl_batch_want_output(AnyslBatch *batch, const char *param) {
  return guarded([&] {
    int index;
    if (AnyslStatus status = provideParam(*batch, param, ANYSL_PARAM_OUTPUT, index))
      return status;
    // Whether Ci and Oi are wanted is another matter: at least one of them is there.
    const AnyslDemandInfo *demand = batch->library->demand;
    const char *const outputs[] = {param, demand && isDropped(*demand, "Ci") ? "Oi" : "Ci",
                                   nullptr};
    AnyslSceneFacts facts = {};
    facts.outputs = outputs;
    if (demand)
      facts.time = demand->time;
    return checkDemand(*batch->library, facts);
  });
}

AnyslStatus anysl_batch_read_output_float(const AnyslBatch *batch, const char *param,
                                          uint32_t first, uint32_t count, float *values,
                                          size_t stride) {
  return guarded([&] { return readOutput(*batch, param, first, count, values, stride); });
}

AnyslStatus anysl_batch_read_output_double(const AnyslBatch *batch, const char *param,
                                           uint32_t first, uint32_t count, double *values,
                                           size_t stride) {
  return guarded([&] { return readOutput(*batch, param, first, count, values, stride); });
}

AnyslStatus anysl_batch_read_output_strings(const AnyslBatch *batch, const char *param,
                                            uint32_t first, uint32_t count, const char **values,
                                            size_t stride) {
  return guarded([&] { return readTexts(*batch, param, first, count, values, stride); });
}

AnyslStatus anysl_batch_unbind(AnyslBatch *batch, const char *param) {
  return guarded([&] {
    int index = findParam(*batch->library, *batch->shader, param);
    if (index < 0)
      return ANYSL_ERROR_NAME;
    batch->paramBuffers[index] = AlignedBuffer();
    batch->paramPointers[index] = nullptr;
    batch->paramFlags[index] = 0;
    for (AnyslBatch::Derivatives *derivatives : {&batch->byU, &batch->byV})
      if (!derivatives->buffers.empty()) {
        derivatives->buffers[index] = AlignedBuffer();
        derivatives->pointers[index] = nullptr;
      }
    return ANYSL_OK;
  });
}

void anysl_batch_set_lights(AnyslBatch *batch, const AnyslLight *lights, uint32_t count,
                            const float ambient[3]) {
  batch->args.lights = lights;
  batch->args.light_count = count;
  for (int i = 0; i < 3; ++i)
    batch->args.ambient[i] = ambient ? ambient[i] : 0;
}

AnyslStatus anysl_batch_set_seeds(AnyslBatch *batch, const uint32_t *seeds) {
  return guarded([&] {
    batch->seeds.assign(seeds ? roundUp(batch->capacity) : 0, 0);
    if (seeds)
      std::copy_n(seeds, batch->capacity, batch->seeds.begin());
    batch->args.seeds = seeds ? batch->seeds.data() : nullptr;
    return ANYSL_OK;
  });
}

const AnyslShadeArgs *anysl_batch_args(const AnyslBatch *batch) { return &batch->args; }

void anysl_batch_set_user(AnyslBatch *batch, void *user) { batch->args.batch = user; }

AnyslStatus anysl_shade(const AnyslInstance *instance, AnyslBatch *batch, uint32_t first,
                        uint32_t last, uint32_t width) {
  return guarded([&] { return shade(*instance, *batch, first, last, width); });
}

} // extern "C"
