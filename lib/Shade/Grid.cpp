//===-- lib/Shade/Grid.cpp - a shader over a grid of points -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Grid.h"
#include "lib/Shade/Timing.h"
#include <algorithm>
#include <cstdio>

namespace anysl::shade {
namespace {

constexpr uint32_t pointsAtOnce = 4096;

std::string plural(size_t count) {
  return std::to_string(count) + (count == 1 ? " number" : " numbers");
}

/// i/(n-1), 0 where the side is 1.
double fraction(size_t i, size_t n) { return n > 1 ? double(i) / double(n - 1) : 0; }
double step(size_t n) { return n > 1 ? 1 / double(n - 1) : 1; }

} // namespace

Grid::Grid(const GridOptions &given)
    : options(given), services(environmentServices()), library(openLibrary(given.library)),
      notes(anysl_note_log_create(library.get())),
      shaderInstance(makeInstance(library.get(), given.shader ? &*given.shader : nullptr, services,
                                  options.environment)),
      lights(given.lights, services, options.environment) {
  adoptRecording();
  lights.checkAllowed(library.get(), options.print);
  for (const CoshaderText &coshader : options.coshaders)
    addCoshader(coshader);
  for (const ParamText &param : options.params)
    setParam(shaderInstance.get(), param, "--param", options.floatInputs);
  for (const Constant &constant : options.constants)
    override(constant.name, constant.value, constant.value, false, "--set");
  for (const Ramp &ramp : options.ramps)
    override(ramp.name, ramp.from, ramp.to, ramp.alongHeight, "--ramp");
  chooseResults();
}

/// Parameters and lights of the command line come on top, spaces in place of those recorded.
void Grid::adoptRecording() {
  if (options.recorded.empty())
    return;
  auto fits = [&](const auto &part) {
    return part->name == shader().name && part->kind == anysl_kind_name(shader().kind);
  };
  auto found = std::find_if(options.recorded.begin(), options.recorded.end(), fits);
  if (found == options.recorded.end())
    throw UserError("--inputs: no points are recorded of the " +
                    std::string(anysl_kind_name(shader().kind)) + " shader '" + shader().name +
                    "'");
  recording = *found;
  // The closed world's ground would cast shadows on points from elsewhere.
  if (!options.environment.surroundingsGiven)
    options.environment.surroundings = Surroundings::Black;
  options.gridWidth = recording->points;
  options.gridHeight = 1;
  for (const auto &[name, matrix] : recording->spaces)
    if (!options.environment.givenSpaces.count(name))
      options.environment.toCurrent[name] = matrix;
  for (const RecordedShader::Param &param : recording->params) {
    if (!param.texts.empty()) {
      std::vector<const char *> texts;
      for (const std::string &text : param.texts)
        texts.push_back(text.c_str());
      check(anysl_instance_set_strings(shaderInstance.get(), param.name.c_str(), texts.data(),
                                       texts.size()));
      continue;
    }
    std::vector<double> numbers = param.numbers;
    round(numbers);
    check(anysl_instance_set_numbers(shaderInstance.get(), param.name.c_str(), numbers.data(),
                                     numbers.size()));
  }
  lights.add(*recording);
  for (const RecordedShader::Values &values : recording->globals)
    recordedGlobals[anysl_global_find(values.name.c_str())] = &values;
}

void Grid::addCoshader(const CoshaderText &text) {
  LibraryHandle opened = openLibrary(text.library);
  const AnyslLibraryInfo &own = *anysl_library_info(library.get());
  const AnyslLibraryInfo &info = *anysl_library_info(opened.get());
  if (info.layout != own.layout || info.real != own.real)
    throw UserError("--coshader: " + text.library + " has another layout or number format than " +
                    options.library);
  InstanceHandle created = makeInstance(opened.get(), nullptr, services, options.environment);
  for (const ParamText &param : text.params)
    setParam(created.get(), param, "--coshader");
  if (!options.environment.coshaders.emplace(text.handle, created.get()).second)
    throw UserError("--coshader: '" + text.handle + "' is given twice");
  for (uint32_t i = 0; i < info.shader_count; ++i)
    if (info.shaders[i].kind == ANYSL_METHOD)
      coshaderGlobals |= info.shaders[i].globals_read | info.shaders[i].globals_written;
  coshaderLibraries.push_back(std::move(opened));
  coshaders.push_back(std::move(created));
}

void Grid::override(const std::string &name, std::vector<double> from, std::vector<double> to,
                    bool alongHeight, const char *option) {
  int global = anysl_global_find(name.c_str());
  const AnyslParamInfo *param = anysl_shader_param(&shader(), name.c_str());
  if (global < 0 && !(param && param->flags & ANYSL_PARAM_VARYING && param->type != ANYSL_STRING))
    throw UserError(std::string(option) + ": '" + name +
                    (param ? "' is a uniform parameter; --param sets those"
                           : "' is neither a shader global nor a varying parameter"));
  if (global >= 0 && anysl_global_is_uniform(global) && from != to)
    throw UserError("--ramp: '" + name + "' has one value for all points; --set sets it");
  size_t size = global >= 0
                    ? anysl_global_components(global)
                    : anysl_type_components(param->type) * std::max(param->array_length, 1u);
  bool spread = from.size() == 1 && size == 3;
  if (from.size() != size && !spread)
    throw UserError(std::string(option) + ": '" + name + "' takes " + plural(size) + ", not " +
                    std::to_string(from.size()));
  if (spread) {
    from.resize(3, from[0]);
    to.resize(3, to[0]);
  }
  Override value = {std::move(from), std::move(to), alongHeight};
  if (global >= 0)
    globalOverrides[global] = std::move(value);
  else
    paramOverrides[name] = std::move(value);
}

void Grid::chooseResults() {
  if (options.print.empty())
    for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
      if (shader().globals_written >> global & 1)
        options.print.push_back(anysl_global_name(global));
  bool wantsCi = std::find(options.print.begin(), options.print.end(), "Ci") != options.print.end();
  if (options.needsColor && !wantsCi)
    options.print.push_back("Ci");
  std::string outputs;
  for (uint32_t i = 0; i < shader().param_count; ++i)
    if (shader().params[i].flags & ANYSL_PARAM_OUTPUT)
      outputs += std::string(outputs.empty() ? "" : ", ") + shader().params[i].name;
  for (const std::string &name : options.print) {
    int global = anysl_global_find(name.c_str());
    const AnyslParamInfo *param = anysl_shader_param(&shader(), name.c_str());
    bool output = param && param->flags & ANYSL_PARAM_OUTPUT;
    if (global < 0 && !output)
      throw UserError("--print: '" + name + "' is neither a shader global nor an output parameter" +
                      (outputs.empty() ? "" : " (those are " + outputs + ")"));
    if (global >= 0) {
      printedGlobals |= uint64_t(1) << global;
      wanted.push_back({name, anysl_global_components(global), 0, {}});
    } else {
      wanted.push_back({name,
                        anysl_type_components(param->type),
                        param->array_length,
                        {},
                        param->type == ANYSL_STRING});
    }
  }
}

void Grid::valueAt(const Override &value, size_t point, double *result) const {
  double x = value.alongHeight ? fraction(point / options.gridWidth, options.gridHeight)
                               : fraction(point % options.gridWidth, options.gridWidth);
  // Exact at both ends.
  for (size_t c = 0; c < value.from.size(); ++c)
    result[c] = x == 1 || value.from[c] == value.to[c]
                    ? value.to[c]
                    : value.from[c] + (value.to[c] - value.from[c]) * x;
}

/// How a ramp changes with u or v.
void Grid::slopeOf(const Override &value, bool byV, double *result) {
  for (size_t c = 0; c < value.from.size(); ++c)
    result[c] = value.alongHeight == byV ? value.to[c] - value.from[c] : 0;
}

/// How a global changes with u or v: as its ramp has it, else as the plain grid does, where s and P
/// follow u and t and P follow v.
void Grid::slopeAt(int global, bool byV, double *result) const {
  std::fill_n(result, anysl_global_components(global), 0);
  auto given = globalOverrides.find(global);
  if (given != globalOverrides.end() && given->second.from != given->second.to) {
    slopeOf(given->second, byV, result);
  } else if (global == ANYSL_P || global == ANYSL_Ps) {
    result[byV ? 1 : 0] = 1;
  } else if (global == (byV ? ANYSL_t : ANYSL_s)) {
    result[0] = 1;
  }
}

void Grid::globalAt(int global, size_t point, double *result) const {
  auto given = globalOverrides.find(global);
  if (given != globalOverrides.end())
    return valueAt(given->second, point, result);
  auto known = recordedGlobals.find(global);
  if (known != recordedGlobals.end()) {
    const RecordedShader::Values &values = *known->second;
    std::copy_n(&values.numbers[point * values.components], values.components, result);
    return;
  }
  double u = fraction(point % options.gridWidth, options.gridWidth);
  double v = fraction(point / options.gridWidth, options.gridHeight);
  auto put = [&](double x, double y = 0, double z = 0) {
    double value[3] = {x, y, z};
    std::copy_n(value, anysl_global_components(global), result);
  };
  switch (global) {
  case ANYSL_P:
  case ANYSL_Ps:
    return put(u, v, 0);
  case ANYSL_N:
  case ANYSL_Ng:
  case ANYSL_Ns:
  case ANYSL_E:
    return put(0, 0, 1);
  case ANYSL_I:
    return put(0, 0, -1);
  case ANYSL_Cs:
  case ANYSL_Os:
    return put(1, 1, 1);
  case ANYSL_Oi:
    return globalAt(ANYSL_Os, point, result);
  case ANYSL_u:
  case ANYSL_s:
    return put(u);
  case ANYSL_v:
  case ANYSL_t:
    return put(v);
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  case ANYSL_##byU:                                                                                \
    return slopeAt(ANYSL_##name, false, result);                                                   \
  case ANYSL_##byV:                                                                                \
    return slopeAt(ANYSL_##name, true, result);
#include <anysl/Globals.def>
  case ANYSL_du:
    return put(step(options.gridWidth));
  case ANYSL_dv:
    return put(step(options.gridHeight));
  case ANYSL_ncomps:
    return put(3);
  case ANYSL_alpha:
    return put(1);
  default:
    return put(0);
  }
}

/// Rounds numbers to what a float holds, if the options say so.
void Grid::round(std::vector<double> &values) const {
  if (options.floatInputs)
    for (double &value : values)
      value = double(float(value));
}

void Grid::fill(AnyslBatch *batch, size_t first, uint32_t count) const {
  std::vector<double> values;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global) {
    if (!(anysl_batch_globals(batch) >> global & 1))
      continue;
    uint32_t components = anysl_global_components(global);
    values.resize(size_t(count) * components);
    for (uint32_t i = 0; i < count; ++i)
      globalAt(global, first + i, &values[size_t(i) * components]);
    round(values);
    check(anysl_batch_write_double(batch, global, 0, count, values.data(), components));
  }
  for (const auto &[name, value] : paramOverrides) {
    size_t components = value.from.size();
    values.resize(count * components);
    for (uint32_t i = 0; i < count; ++i)
      valueAt(value, first + i, &values[i * components]);
    round(values);
    check(anysl_batch_bind_double(batch, name.c_str(), 0, count, values.data(), components));
    std::vector<double> byU(components), byV(components);
    slopeOf(value, false, byU.data());
    slopeOf(value, true, byV.data());
    round(byU);
    round(byV);
    check(anysl_batch_bind_derivatives_double(batch, name.c_str(), 0, count, byU.data(), byV.data(),
                                              0));
  }
  if (recording)
    bindRecorded(batch, first, count);
  // A point's random numbers do not depend on how the grid is cut into batches.
  std::vector<uint32_t> seeds(count);
  for (uint32_t i = 0; i < count; ++i)
    seeds[i] = recording ? recording->seeds[first + i] : uint32_t(first + i);
  check(anysl_batch_set_seeds(batch, seeds.data()));
}

void Grid::bindRecorded(AnyslBatch *batch, size_t first, uint32_t count) const {
  for (const RecordedShader::Values &value : recording->varying)
    if (!paramOverrides.count(value.name))
      check(anysl_batch_bind_float(batch, value.name.c_str(), 0, count,
                                   &value.numbers[first * value.components], value.components));
  for (size_t i = 0; i < recording->byU.size(); ++i) {
    const RecordedShader::Values &byU = recording->byU[i], &byV = recording->byV[i];
    size_t at = first * byU.components;
    if (!paramOverrides.count(byU.name))
      check(anysl_batch_bind_derivatives_float(batch, byU.name.c_str(), 0, count, &byU.numbers[at],
                                               &byV.numbers[at], byU.components));
  }
}

BatchHandle Grid::makeBatch(size_t first, uint32_t count) const {
  AnyslBatch *created = nullptr;
  check(anysl_batch_create(instance(), count, printedGlobals | lights.globals() | coshaderGlobals,
                           &created));
  BatchHandle batch(created);
  lights.shineOn(created);
  for (const Result &result : wanted)
    if (anysl_global_find(result.name.c_str()) < 0)
      check(anysl_batch_want_output(created, result.name.c_str()));
  fill(created, first, count);
  return batch;
}

void Grid::readTexts(const AnyslBatch *batch, size_t first, uint32_t count, Result &result) {
  std::vector<const char *> texts(size_t(count) * result.perPoint());
  check(anysl_batch_read_output_strings(batch, result.name.c_str(), 0, count, texts.data(),
                                        result.perPoint()));
  std::copy(texts.begin(), texts.end(), result.texts.begin() + first * result.perPoint());
}

double Grid::secondsFor(AnyslBatch *batch, unsigned width, unsigned times) const {
  auto count = uint32_t(pointCount());
  // Fresh inputs: a shader may move P at every run.
  fill(batch, 0, count);
  double start = threadSeconds();
  for (unsigned i = 0; i < times; ++i)
    check(anysl_shade(instance(), batch, 0, count, width));
  return threadSeconds() - start;
}

std::vector<Result> Grid::shade(unsigned width) const {
  std::vector<Result> results = wanted;
  for (Result &result : results)
    if (result.isText)
      result.texts.resize(pointCount() * result.perPoint());
    else
      result.values.resize(pointCount() * result.perPoint());
  for (size_t first = 0; first < pointCount(); first += pointsAtOnce) {
    auto count = uint32_t(std::min<size_t>(pointsAtOnce, pointCount() - first));
    BatchHandle batch = makeBatch(first, count);
    if (notes)
      anysl_note_log_count_from(notes.get(), first);
    check(anysl_shade(instance(), batch.get(), 0, count, width ? width : options.width));
    for (Result &result : results) {
      if (result.isText) {
        readTexts(batch.get(), first, count, result);
        continue;
      }
      int global = anysl_global_find(result.name.c_str());
      double *values = &result.values[first * result.perPoint()];
      check(global >= 0
                ? anysl_batch_read_double(batch.get(), global, 0, count, values, result.perPoint())
                : anysl_batch_read_output_double(batch.get(), result.name.c_str(), 0, count, values,
                                                 result.perPoint()));
    }
  }
  return results;
}

} // namespace anysl::shade
