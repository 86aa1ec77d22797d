//===-- lib/Shade/Grid.h - a shader over a grid of points ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_GRID_H
#define ANYSL_LIB_SHADE_GRID_H

#include "lib/Shade/Lights.h"
#include <array>
#include <map>

namespace anysl::shade {

/// One shaded quantity at every point of the grid, row by row.
struct Result {
  std::string name;
  uint32_t components; ///< of one element
  uint32_t elements;   ///< 0: not an array
  std::vector<double> values;
  bool isText = false;
  std::vector<std::string> texts{}; ///< instead of values

  uint32_t perPoint() const { return components * (elements ? elements : 1); }
};

/// A shader instance as the command line describes it. Its functions throw UserError.
class Grid {
public:
  explicit Grid(const GridOptions &options);

  /// Shades every point, a few thousand at a time, with the code for a width (0: the options').
  std::vector<Result> shade(unsigned width = 0) const;

  /// Seconds of this thread that shading all points takes, \p times times, in a batch of
  /// makeBatch() that holds all of them. Filling it is not counted.
  double secondsFor(AnyslBatch *batch, unsigned width, unsigned times) const;

  /// Prints what the shader's library has noted while shading, each place once.
  void printNotes() const { shade::printNotes(notes.get(), stderr); }

  /// A batch that holds points [first, first + count), counted row by row.
  BatchHandle makeBatch(size_t first, uint32_t count) const;
  /// Puts the inputs of these points into a batch.
  void fill(AnyslBatch *batch, size_t first, uint32_t count) const;
  unsigned width() const { return options.gridWidth; }
  unsigned height() const { return options.gridHeight; }
  size_t pointCount() const { return size_t(options.gridWidth) * options.gridHeight; }

  const AnyslLibrary *shaderLibrary() const { return library.get(); }
  const AnyslInstance *instance() const { return shaderInstance.get(); }
  const AnyslShaderInfo &shader() const { return *anysl_instance_shader(instance()); }
  /// Whether the shader computes in double precision.
  bool isDouble() const { return anysl_library_info(library.get())->real == ANYSL_REAL_DOUBLE; }

private:
  /// A value that the command line gives to a global or varying parameter instead of the grid's
  /// own.
  struct Override {
    std::vector<double> from, to; ///< padded to all components
    bool alongHeight = false;
  };

  void adoptRecording();
  void addCoshader(const CoshaderText &text);
  void override(const std::string &name, std::vector<double> from, std::vector<double> to,
                bool alongHeight, const char *option);
  void chooseResults();
  static void readTexts(const AnyslBatch *batch, size_t first, uint32_t count, Result &result);
  void round(std::vector<double> &values) const;
  void valueAt(const Override &value, size_t point, double *result) const;
  void globalAt(int global, size_t point, double *result) const;
  /// Binds the parameters that a recording has point by point.
  void bindRecorded(AnyslBatch *batch, size_t first, uint32_t count) const;
  static void slopeOf(const Override &value, bool byV, double *result);
  void slopeAt(int global, bool byV, double *result) const;

  GridOptions options;
  AnyslServices services;
  LibraryHandle library;
  NoteLogHandle notes; ///< null: the library notes nothing
  InstanceHandle shaderInstance;
  Lights lights;
  std::vector<LibraryHandle> coshaderLibraries;
  std::vector<InstanceHandle> coshaders;
  uint64_t coshaderGlobals = 0;                    ///< that their methods name
  std::shared_ptr<const RecordedShader> recording; ///< null: a grid
  std::map<int, const RecordedShader::Values *> recordedGlobals;
  std::map<int, Override> globalOverrides;
  std::map<std::string, Override> paramOverrides;
  std::vector<Result> wanted; ///< without values
  uint64_t printedGlobals = 0;
};

} // namespace anysl::shade

#endif
