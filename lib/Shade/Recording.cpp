//===-- lib/Shade/Recording.cpp - shading points of a real scene, in a file -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Recording.h"
#include "lib/Shade/Options.h"
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <tuple>

namespace anysl::shade {
namespace {

constexpr const char *firstLine = "anysl-points 1";

std::string quoted(const std::string &text) {
  std::string result = "\"";
  for (char c : text)
    if (c == '\n')
      result += "\\n";
    else
      result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return result + '"';
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, " %.17g", value);
  return text;
}

/// The fields of a light in the order of AnyslLight, as pointers to its numbers.
template <typename Light>
auto numbersOf(Light &light) {
  std::vector<decltype(&light.beam)> result;
  for (auto *triple : {light.color, light.from, light.direction})
    result.insert(result.end(), {triple, triple + 1, triple + 2});
  result.insert(result.end(), {&light.cos_outer, &light.cos_inner, &light.beam});
  return result;
}

void writeHead(std::ostream &out, const RecordedShader &shader) {
  out << "shader " << quoted(shader.kind) << ' ' << quoted(shader.name) << "\nfile "
      << quoted(shader.file) << "\npoints " << shader.points << '\n';
  for (const RecordedShader::Param &param : shader.params) {
    out << (param.texts.empty() ? "param " : "text ") << quoted(param.name);
    for (double value : param.numbers)
      out << number(value);
    for (const std::string &text : param.texts)
      out << ' ' << quoted(text);
    out << '\n';
  }
  for (const auto &[name, matrix] : shader.spaces) {
    out << "space " << quoted(name);
    for (double value : matrix)
      out << number(value);
    out << '\n';
  }
  out << "ambient";
  for (float value : shader.ambient)
    out << number(value);
  for (const RecordedShader::Light &light : shader.lights) {
    out << "\nlight " << light.values.kind << ' ' << light.values.flags;
    for (const float *value : numbersOf(light.values))
      out << number(*value);
    out << ' ' << quoted(light.category);
  }
  out << '\n';
  if (shader.lostLights)
    out << "lost " << shader.lostLights << '\n';
  for (const RecordedShader::Values &values : shader.globals)
    out << "global " << quoted(values.name) << '\n';
  auto writeLines = [&](const char *key, const std::vector<RecordedShader::Values> &list) {
    for (const RecordedShader::Values &values : list)
      out << key << ' ' << quoted(values.name) << ' ' << values.components << '\n';
  };
  writeLines("varying", shader.varying);
  writeLines("byU", shader.byU);
  writeLines("byV", shader.byV);
  out << "data\n";
}

template <typename T>
void writeNumbers(std::ostream &out, const std::vector<T> &numbers) {
  out.write(reinterpret_cast<const char *>(numbers.data()),
            std::streamsize(numbers.size() * sizeof(T)));
}

/// Reads a file that is in memory.
class Reader {
public:
  Reader(const std::string &path, std::string contents) : path(path), text(std::move(contents)) {}

  std::vector<RecordedShader> read() {
    if (nextLine() != firstLine)
      fail("is not a file of recorded points");
    std::vector<RecordedShader> result;
    while (at < text.size())
      result.push_back(readShader());
    return result;
  }

private:
  [[noreturn]] void fail(const std::string &what) const {
    throw UserError("'" + path + "' " + what);
  }
  [[noreturn]] void failHere() const {
    fail("is damaged: line " + std::to_string(line) + " makes no sense");
  }

  std::string nextLine() {
    ++line;
    size_t end = std::min(text.find('\n', at), text.size());
    std::string result = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    return result;
  }

  /// The words of a line; a text loses its quotes.
  std::vector<std::string> wordsOf(const std::string &from) const {
    std::vector<std::string> words;
    for (size_t i = 0; i < from.size();) {
      std::string word;
      if (from[i] == '"') {
        for (++i; i < from.size() && from[i] != '"'; ++i) {
          bool escaped = from[i] == '\\' && i + 1 < from.size();
          i += escaped;
          word += escaped && from[i] == 'n' ? '\n' : from[i];
        }
        ++i;
      } else {
        while (i < from.size() && from[i] != ' ')
          word += from[i++];
      }
      words.push_back(word);
      ++i; // the space
    }
    return words;
  }

  double numberOf(const std::string &word) const {
    double value = 0;
    auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      failHere();
    return value;
  }

  std::vector<double> numbersFrom(const std::vector<std::string> &words, size_t first) const {
    std::vector<double> result;
    for (size_t i = first; i < words.size(); ++i)
      result.push_back(numberOf(words[i]));
    return result;
  }

  template <typename T>
  void readNumbers(std::vector<T> &numbers, size_t count) {
    if ((text.size() - at) / sizeof(T) < count)
      fail("is damaged: it ends too early");
    numbers.resize(count);
    std::memcpy(numbers.data(), text.data() + at, count * sizeof(T));
    at += count * sizeof(T);
  }

  void readLight(RecordedShader &shader, const std::vector<std::string> &words) {
    RecordedShader::Light light;
    auto numbers = numbersOf(light.values);
    if (words.size() != 4 + numbers.size())
      failHere();
    light.values.kind = uint32_t(numberOf(words[1]));
    light.values.flags = uint32_t(numberOf(words[2]));
    for (size_t i = 0; i < numbers.size(); ++i)
      *numbers[i] = float(numberOf(words[3 + i]));
    light.category = words.back();
    shader.lights.push_back(std::move(light));
  }

  RecordedShader readShader() {
    RecordedShader shader;
    for (;;) {
      if (at == text.size())
        fail("is damaged: it ends too early");
      std::vector<std::string> words = wordsOf(nextLine());
      const std::string key = words.empty() ? "" : words[0];
      size_t count = words.size();
      if (key == "data")
        break;
      else if (key == "shader" && count == 3)
        shader.kind = words[1], shader.name = words[2];
      else if (key == "file" && count == 2)
        shader.file = words[1];
      else if (key == "points" && count == 2)
        shader.points = uint32_t(numberOf(words[1]));
      else if (key == "param" && count > 1)
        shader.params.push_back({words[1], numbersFrom(words, 2), {}});
      else if (key == "text" && count > 2)
        shader.params.push_back({words[1], {}, {words.begin() + 2, words.end()}});
      else if (key == "space" && count == 18) {
        std::vector<double> numbers = numbersFrom(words, 2);
        std::copy_n(numbers.begin(), 16, shader.spaces[words[1]].begin());
      } else if (key == "ambient" && count == 4)
        for (size_t c = 0; c < 3; ++c)
          shader.ambient[c] = float(numberOf(words[1 + c]));
      else if (key == "light")
        readLight(shader, words);
      else if (key == "lost" && count == 2)
        shader.lostLights = unsigned(numberOf(words[1]));
      else if (key == "global" && count == 2 && anysl_global_find(words[1].c_str()) >= 0)
        shader.globals.push_back(
            {words[1], anysl_global_components(anysl_global_find(words[1].c_str())), {}});
      else if ((key == "varying" || key == "byU" || key == "byV") && count == 3)
        (key == "varying" ? shader.varying
         : key == "byU"   ? shader.byU
                          : shader.byV)
            .push_back({words[1], uint32_t(numberOf(words[2])), {}});
      else
        failHere();
    }
    auto isSame = [](const RecordedShader::Values &a, const RecordedShader::Values &b) {
      return a.name == b.name && a.components == b.components;
    };
    if (!std::ranges::equal(shader.byU, shader.byV, isSame))
      fail("is damaged: not all parameters that change with u change with v");
    for (auto *list : shader.lists())
      for (RecordedShader::Values &values : *list)
        readNumbers(values.numbers, size_t(shader.points) * values.components);
    readNumbers(shader.seeds, shader.points);
    return shader;
  }

  const std::string &path;
  std::string text;
  size_t at = 0;
  unsigned line = 0;
};

/// A number of a batch, whatever its layout and format.
class BatchNumbers {
public:
  explicit BatchNumbers(const AnyslShadeArgs &args)
      : args(args), isArrays(args.library->layout == ANYSL_LAYOUT_SOA),
        isDouble(args.library->real == ANYSL_REAL_DOUBLE) {}

  float global(int global, uint32_t component, uint32_t point) const {
    uint32_t all = firstComponent[global] + component;
    if (isArrays)
      return number(args.globals[all], anysl_global_is_uniform(global) ? 0 : point);
    return number(args.globals[0], size_t(point) * ANYSL_COMPONENT_COUNT + all);
  }
  float param(uint32_t param, uint32_t components, uint32_t k, uint32_t point) const {
    return float(anysl_param_number(&args, param, place(components, k, point)));
  }
  /// A derivative of it, out of args.param_by_u or param_by_v.
  float slope(void *const *arrays, uint32_t param, uint32_t components, uint32_t k,
              uint32_t point) const {
    return number(arrays[param], place(components, k, point));
  }

private:
  /// Where number k of a parameter lies.
  size_t place(uint32_t components, uint32_t k, uint32_t point) const {
    uint32_t element = k / components, c = k % components;
    return isArrays ? (size_t(element) * components + c) * args.data_stride + point
                    : (element * args.data_stride + point) * components + c;
  }

  static constexpr uint32_t firstComponent[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_COMPONENT_##name,
#include <anysl/Globals.def>
  };
  float number(const void *array, size_t index) const {
    return isDouble ? float(static_cast<const double *>(array)[index])
                    : static_cast<const float *>(array)[index];
  }

  const AnyslShadeArgs &args;
  bool isArrays, isDouble;
};

/// A number that scatters seeds, which may follow each other (the finalizer of MurmurHash3).
uint64_t scattered(uint32_t seed) {
  uint64_t h = seed + 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdu;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53u;
  return h ^ (h >> 33);
}

} // namespace

void writeRecording(const std::string &path, const std::vector<RecordedShader> &shaders) {
  std::ofstream out(path, std::ios::binary);
  out << firstLine << '\n';
  for (const RecordedShader &shader : shaders) {
    writeHead(out, shader);
    for (auto *list : shader.lists())
      for (const RecordedShader::Values &values : *list)
        writeNumbers(out, values.numbers);
    writeNumbers(out, shader.seeds);
  }
  out.close();
  if (out)
    return;
  std::remove(path.c_str());
  throw UserError("cannot write '" + path + "'");
}

std::vector<RecordedShader> readRecording(const std::string &path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw UserError("cannot read '" + path + "'");
  return Reader(path, std::string(std::istreambuf_iterator<char>(in), {})).read();
}

void Recorder::begin(Part &part, const AnyslInstance &instance, const AnyslShadeArgs &args,
                     const std::string &file) const {
  const AnyslShaderInfo &info = *anysl_instance_shader(&instance);
  RecordedShader &shader = part.shader;
  shader.kind = anysl_kind_name(info.kind);
  shader.name = info.name;
  shader.file = file;
  for (uint32_t p = 0; p < info.param_count; ++p) {
    const AnyslParamInfo &param = info.params[p];
    uint32_t components = anysl_type_components(param.type);
    uint32_t cells = components * std::max(param.array_length, 1u);
    if (args.param_data && args.param_data[p] && !(args.param_is_set[p] & ANYSL_PARAM_ONLY_OUT)) {
      shader.varying.push_back({param.name, cells, {}});
      if ((param.flags & ANYSL_PARAM_DIFFERENTIATED) && args.param_by_u && args.param_by_u[p]) {
        shader.byU.push_back({param.name, cells, {}});
        shader.byV.push_back({param.name, cells, {}});
      }
    }
    if (!(args.param_is_set[p] & ANYSL_PARAM_GIVEN))
      continue;
    RecordedShader::Param &given = shader.params.emplace_back();
    given.name = param.name;
    for (uint32_t k = 0; k < cells; ++k)
      if (const AnyslCell &cell = args.params[param.first_cell + k]; param.type == ANYSL_STRING)
        given.texts.push_back(cell.string ? cell.string : "");
      else
        given.numbers.push_back(cell.number);
  }
  for (const char *space : {"shader", "object", "world", "camera"}) {
    std::array<double, 16> matrix;
    if (args.services->space_matrix &&
        args.services->space_matrix(args.renderer, &args, space, "current", matrix.data()))
      shader.spaces[space] = matrix;
  }
  std::copy_n(args.ambient, 3, shader.ambient);
  for (uint32_t i = 0; i < args.light_count; ++i) {
    const AnyslLight &light = args.lights[i];
    if (light.kind == ANYSL_LIGHT_SHADER) {
      ++shader.lostLights;
      continue;
    }
    RecordedShader::Light &kept = shader.lights.emplace_back();
    kept.values = light;
    kept.values.category = nullptr;
    kept.values.shader = nullptr;
    kept.category = light.category ? light.category : "";
  }
  uint64_t globals = info.globals_read | info.globals_written;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if (globals >> global & 1)
      shader.globals.push_back({anysl_global_name(global), anysl_global_components(global), {}});
}

void Recorder::add(const AnyslInstance &instance, const AnyslShadeArgs &args, const void *key,
                   const std::string &file) {
  const AnyslShaderInfo &info = *anysl_instance_shader(&instance);
  BatchNumbers batch(args);
  std::lock_guard guard(lock);
  auto [place, isNew] = parts.try_emplace({&instance, key});
  Part &part = place->second;
  if (isNew)
    begin(part, instance, args, file);
  for (uint32_t i = 0; i < args.count; ++i) {
    uint32_t seed = args.seeds ? args.seeds[i] : i;
    uint64_t rank = scattered(seed);
    if (part.points.size() >= limit && rank >= part.points.rbegin()->first)
      continue;
    std::vector<float> numbers;
    for (const RecordedShader::Values &values : part.shader.globals)
      for (uint32_t c = 0; c < values.components; ++c)
        numbers.push_back(batch.global(anysl_global_find(values.name.c_str()), c, i));
    auto addParams = [&](const std::vector<RecordedShader::Values> &list, const auto &numberOf) {
      for (const RecordedShader::Values &values : list) {
        auto param = uint32_t(anysl_shader_param(&info, values.name.c_str()) - info.params);
        for (uint32_t k = 0; k < values.components; ++k)
          numbers.push_back(numberOf(param, anysl_type_components(info.params[param].type), k));
      }
    };
    auto slopesIn = [&](void *const *arrays) {
      return [&batch, i, arrays](uint32_t param, uint32_t components, uint32_t k) {
        return batch.slope(arrays, param, components, k, i);
      };
    };
    addParams(part.shader.varying, [&](uint32_t param, uint32_t components, uint32_t k) {
      return batch.param(param, components, k, i);
    });
    addParams(part.shader.byU, slopesIn(args.param_by_u));
    addParams(part.shader.byV, slopesIn(args.param_by_v));
    part.points.emplace(rank, std::pair(seed, std::move(numbers)));
    if (part.points.size() > limit)
      part.points.erase(std::prev(part.points.end()));
  }
}

std::vector<RecordedShader> Recorder::take() {
  std::vector<RecordedShader> result;
  for (auto &[key, part] : parts) {
    RecordedShader &shader = part.shader;
    shader.points = uint32_t(part.points.size());
    for (const auto &[rank, point] : part.points) {
      shader.seeds.push_back(point.first);
      const float *from = point.second.data();
      for (auto *list : shader.lists())
        for (RecordedShader::Values &values : *list) {
          values.numbers.insert(values.numbers.end(), from, from + values.components);
          from += values.components;
        }
    }
    result.push_back(std::move(shader));
  }
  parts.clear();
  // Threads meet shaders in any order.
  std::sort(result.begin(), result.end(), [](const RecordedShader &a, const RecordedShader &b) {
    return std::tie(a.kind, a.name, a.points, a.seeds) <
           std::tie(b.kind, b.name, b.points, b.seeds);
  });
  return result;
}

} // namespace anysl::shade
