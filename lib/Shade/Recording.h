//===-- lib/Shade/Recording.h - shading points of a real scene, in a file ---------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A renderer writes what it calls shaders with, and the programs that shade without a renderer read
// it in place of their grid. A file has one part for each shader with one set of parameters and
// lights. It begins with lines of text, words separated by one space, texts in quotes with
// backslashes before quotes and backslashes, and \n for a line's end:
//
//     anysl-points 1                    only before the first part; 1 is the version
//     shader "surface" "marble"         its kind and name
//     file "/scenes/marble.sl"          where it came from: source, STC or library
//     points 4096
//     param "Kd" 0.5                    given parameters: all numbers,
//     text "map" "wood.tx"              or all texts
//     space "world" m m ... m           16 numbers: from a named space to "current", row by row
//     ambient r g b
//     light k f c c c p p p d d d o i b "category"    the fields of AnyslLight, in order
//     lost 2                            how many of the lights are light shaders, which are not
//                                       kept
//     global "P"                        one for each global that is kept,
//     varying "Cv" 3                    and each parameter bound point by point: numbers a point
//     byU "Cv" 3                        how those change with u and
//     byV "Cv" 3                        with v, where the shader reads that
//     data
//
// Then, little-endian and without gaps: for each of these lists, in the order of its lines, the
// floats of point 0, of point 1, ...; and at last a 32-bit seed for each point.
// What rays meet, pictures, and answers to questions by name are not kept.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_RECORDING_H
#define ANYSL_LIB_SHADE_RECORDING_H

#include <anysl/anysl.h>
#include <array>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace anysl::shade {

struct RecordedShader {
  struct Param {
    std::string name;
    std::vector<double> numbers;
    std::vector<std::string> texts; ///< instead of numbers
  };
  struct Light {
    AnyslLight values = {}; ///< without its category
    std::string category;
  };
  struct Values {
    std::string name;
    uint32_t components = 1;
    std::vector<float> numbers; ///< point by point
  };

  std::string kind, name, file;
  uint32_t points = 0;
  std::vector<Param> params;
  std::map<std::string, std::array<double, 16>> spaces;
  float ambient[3] = {0, 0, 0};
  std::vector<Light> lights;
  unsigned lostLights = 0;
  std::vector<Values> globals, varying, byU, byV;
  std::vector<uint32_t> seeds;

  /// All numbers that differ from point to point, in the file's order.
  std::array<std::vector<Values> *, 4> lists() { return {&globals, &varying, &byU, &byV}; }
  std::array<const std::vector<Values> *, 4> lists() const {
    return {&globals, &varying, &byU, &byV};
  }
};

/// Writes a file, or throws UserError and leaves none.
void writeRecording(const std::string &path, const std::vector<RecordedShader> &shaders);
/// Reads one. Throws UserError.
std::vector<RecordedShader> readRecording(const std::string &path);

/// Collects what a renderer calls its shaders with. Of each shader it keeps a limited number of
/// points, chosen by their seeds, so that the choice does not depend on threads.
class Recorder {
public:
  explicit Recorder(uint32_t pointsPerShader) : limit(pointsPerShader) {}

  /// Just before a shader of an instance runs over all points of \p args; any thread. \p key tells
  /// batches apart that have other lights or spaces.
  void add(const AnyslInstance &instance, const AnyslShadeArgs &args, const void *key,
           const std::string &file);

  /// What has been collected, sorted by the shaders' names.
  std::vector<RecordedShader> take();

private:
  struct Part {
    RecordedShader shader;
    /// Each point's numbers, globals and parameters one after the other, by the hash of its seed.
    std::multimap<uint64_t, std::pair<uint32_t, std::vector<float>>> points;
  };

  void begin(Part &part, const AnyslInstance &instance, const AnyslShadeArgs &args,
             const std::string &file) const;

  uint32_t limit;
  std::mutex lock;
  std::map<std::pair<const void *, const void *>, Part> parts;
};

} // namespace anysl::shade

#endif
