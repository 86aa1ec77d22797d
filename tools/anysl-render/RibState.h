//===-- tools/anysl-render/RibState.h - the graphics state of a RIB file ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A request of the file is its name with all arguments up to the next request. The table
// RibRequests.def maps its name to a member function of RibState, which reads the arguments through
// RibArguments; so a request is added by one line and one function.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RIBSTATE_H
#define ANYSL_RENDER_RIBSTATE_H

#include "tools/anysl-render/PrimitiveVariables.h"
#include "tools/anysl-render/RibArguments.h"

#include <unordered_map>

namespace anysl::render {

/// The state that requests change, and the scenes they have made so far.
class RibState {
public:
  RibState(std::string baseName, Warnings &warnings)
      : baseName(std::move(baseName)), warnings(warnings) {}

  /// Does one request.
  void execute(const RibRequest &request);
  /// Ends the file: every block must be closed and some world must have been seen.
  std::vector<SceneDescription> finish(const Location &end);

private:
  using Handler = void (RibState::*)(RibArguments &);
  static const std::unordered_map<std::string_view, Handler> &table();

  enum class Block { Frame, World, Attribute, Transform };
  struct OpenBlock {
    Block kind;
    Location where;
  };
  struct GraphicsState {
    Appearance appearance;
    Matrix4 transform = Matrix4::identity(); ///< object to camera
    bool lightShadows = true;
    Basis basisU = Basis::bezier, basisV = Basis::bezier;
  };

#define RIB_REQUEST(name, handler) void handler(RibArguments &);
#include "tools/anysl-render/RibRequests.def"

  void open(Block kind, const RibArguments &arguments);
  void close(Block kind, const char *name, const RibArguments &arguments);
  bool inWorld() const;
  void concatenate(const Matrix4 &matrix) { state.transform = matrix * state.transform; }
  /// The shader that a request names: an index into the scene's, or -1 for "null" and "".
  int addShader(ShaderKind kind, RibArguments &arguments);
  /// Adds a shape with its variables. Throws ShapeError where there is something wrong with them.
  void addShape(ShapeGeometry geometry, ParameterList variables, const VariableCounts &counts,
                RibArguments &arguments);
  void addPolygons(PolygonShape shape, ParameterList variables, RibArguments &arguments);
  void addPatches(PatchShape shape, RibArguments &arguments);
  void addQuadric(QuadricShape shape, RibArguments &arguments);
  /// Warns once that a name of an option, attribute or parameter means nothing here.
  void warnUnknown(const char *what, const std::string &name, const Location &where);

  std::string baseName;
  Warnings &warnings;
  std::map<std::string, Declaration, std::less<>> declarations;
  GraphicsState state;
  std::vector<GraphicsState> savedStates;
  SceneDescription scene;
  std::vector<SceneDescription> savedScenes; ///< options before FrameBegin and WorldBegin
  std::vector<OpenBlock> blocks;
  std::map<std::string, uint32_t, std::less<>> lightHandles;
  std::vector<SceneDescription> finished;
};

} // namespace anysl::render

#endif
