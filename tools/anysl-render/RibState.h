//===-- tools/anysl-render/RibState.h - the graphics state of a RIB file ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A request of the file is its name with all arguments up to the next request. The table in
// RibRequests.cpp maps its name to a member function of RibState, which reads the arguments through
// RibArguments; so a request is added by one line and one function.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RIBSTATE_H
#define ANYSL_RENDER_RIBSTATE_H

#include "tools/anysl-render/SceneDescription.h"

#include <functional>
#include <span>

namespace anysl::render {

/// A number, a string, or an array of one of them.
struct RibArgument {
  Location where;
  bool isArray = false;
  std::vector<double> numbers;
  std::vector<std::string> strings;
};

struct RibRequest {
  std::string name;
  Location where;
  std::vector<RibArgument> arguments;
};

/// Hands out a request's arguments in order, or throws UserError saying what is missing.
class RibArguments {
public:
  RibArguments(const RibRequest &request,
               const std::map<std::string, Declaration, std::less<>> &declarations)
      : request(request), declarations(declarations) {}

  const Location &where() const { return request.where; }
  bool empty() const { return next == request.arguments.size(); }

  double number(const char *what);
  std::string string(const char *what);
  /// `count` numbers, one by one or as an array.
  std::vector<double> numbers(size_t count, const char *what);
  Vec3d triple(const char *what);
  Matrix4 matrix();
  /// An array of any length.
  std::vector<double> array(const char *what);
  /// An array of indices or counts, none of them negative.
  std::vector<uint32_t> indices(const char *what);
  /// A light's or object's name: a number or a string.
  std::string handle(const char *what);
  /// All that is left, as pairs of a name and its values.
  ParameterList parameters();

private:
  const RibArgument &take(const char *what);

  const RibRequest &request;
  const std::map<std::string, Declaration, std::less<>> &declarations;
  size_t next = 0;
};

/// Reads "uniform color[2] name"; the name is left out where `name` is null.
/// Throws UserError at `where` if the text is no declaration.
Declaration parseDeclaration(std::string_view text, std::string *name, const Location &where);

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
  struct TableEntry {
    const char *name;
    Handler handler;
  };
  static std::span<const TableEntry> table();

  enum class Block { Frame, World, Attribute, Transform };
  struct OpenBlock {
    Block kind;
    Location where;
  };
  struct GraphicsState {
    Appearance appearance;
    Matrix4 transform = Matrix4::identity(); ///< object to camera
    bool lightShadows = true;
  };

  // Structure
  void frameBegin(RibArguments &), frameEnd(RibArguments &);
  void worldBegin(RibArguments &), worldEnd(RibArguments &);
  void attributeBegin(RibArguments &), attributeEnd(RibArguments &);
  void transformBegin(RibArguments &), transformEnd(RibArguments &);
  void declare(RibArguments &), ignored(RibArguments &);
  // Options
  void display(RibArguments &), format(RibArguments &), projection(RibArguments &);
  void pixelSamples(RibArguments &), pixelFilter(RibArguments &), exposure(RibArguments &);
  void screenWindow(RibArguments &), cropWindow(RibArguments &), clipping(RibArguments &);
  void frameAspectRatio(RibArguments &), shutter(RibArguments &), option(RibArguments &);
  // Transformations
  void identity(RibArguments &), transform(RibArguments &), concatTransform(RibArguments &);
  void translate(RibArguments &), rotate(RibArguments &), scale(RibArguments &);
  void coordinateSystem(RibArguments &);
  // Attributes
  void color(RibArguments &), opacity(RibArguments &), surface(RibArguments &);
  void lightSource(RibArguments &), illuminate(RibArguments &), sides(RibArguments &);
  void orientation(RibArguments &), reverseOrientation(RibArguments &);
  void textureCoordinates(RibArguments &), attribute(RibArguments &);
  // Shapes
  void sphere(RibArguments &), cone(RibArguments &), cylinder(RibArguments &);
  void hyperboloid(RibArguments &), paraboloid(RibArguments &), disk(RibArguments &);
  void torus(RibArguments &), polygon(RibArguments &), pointsPolygons(RibArguments &);

  void open(Block kind, const RibArguments &arguments);
  void close(Block kind, const char *name, const RibArguments &arguments);
  bool inWorld() const;
  void concatenate(const Matrix4 &matrix) { state.transform = matrix * state.transform; }
  void addShape(std::variant<QuadricShape, PolygonShape> geometry, RibArguments &arguments);
  void addPolygons(PolygonShape shape, RibArguments &arguments);
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
