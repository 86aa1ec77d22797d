//===-- lib/Rib/RibState.h - the graphics state of a RIB file ---------------------*- C++ -*---===//
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

#ifndef ANYSL_LIB_RIB_RIBSTATE_H
#define ANYSL_LIB_RIB_RIBSTATE_H

#include "lib/Rib/PrimitiveVariables.h"
#include "lib/Rib/RibArguments.h"

#include <filesystem>
#include <unordered_map>

namespace anysl::render {

/// Requests that are kept for later.
using Recording = std::shared_ptr<std::vector<RibRequest>>;
/// ObjectBegin, ArchiveBegin or MotionBegin whose end has not come yet.
struct OpenRecording {
  std::string begin, end; ///< the requests' names
  unsigned depth = 1;     ///< of blocks of the same kind
  std::string handle;
  Location where;
  Recording requests = std::make_shared<std::vector<RibRequest>>();
};

/// The state that requests change, and the scenes they have made so far.
class RibState {
public:
  /// `fileName` is the scene's, from whose folder files are looked for.
  RibState(const std::string &fileName, Warnings &warnings);

  /// Does one request.
  void execute(const RibRequest &request);
  /// Ends the file: every block must be closed and some world must have been seen.
  std::vector<SceneDescription> finish(const Location &end);

private:
  using Handler = void (RibState::*)(RibArguments &);
  static const std::unordered_map<std::string_view, Handler> &table();

  enum class Block { Frame, World, Attribute, Transform, Solid };
  struct OpenBlock {
    Block kind;
    Location where;
  };
  struct GraphicsState {
    Appearance appearance;
    Matrix4 transform = Matrix4::identity(); ///< object to camera
    bool lightShadows = true;
    Basis basisU = Basis::bezier, basisV = Basis::bezier;
    std::shared_ptr<const std::vector<NurbsShape::TrimLoop>> trims; ///< null: none
    int areaLight = -1;     ///< the light that shapes belong to: an index into the scene's, or -1
    double detail = 0;      ///< of the bound that Detail has stated, in pixels; 0: none
    bool isLeftOut = false; ///< DetailRange says that another version of it is seen
  };
  struct Condition {
    Location where;
    bool taken;  ///< some branch has been, or the whole block is passed over
    bool active; ///< the present branch is done
  };

#define RIB_REQUEST(name, handler) void handler(RibArguments &);
#include "lib/Rib/RibRequests.def"

  class Enclosure;
  void record(const RibRequest &request);
  void startRecording(const char *begin, const char *end, std::string handle,
                      const RibArguments &arguments);
  /// Does what has been recorded, as if it stood here. What it opens it has to close.
  void replay(const Recording &requests, const Location &where);
  /// Does a motion block's request as it is when the shutter opens.
  void doMotion(const OpenRecording &motion);
  /// Reads a file or an archive of the scene's own.
  void includeArchive(const std::string &name, const Location &where);
  std::filesystem::path findArchive(const std::string &name, const Location &where) const;
  bool isPassedOver() const { return !conditions.empty() && !conditions.back().active; }
  bool evaluate(const std::string &expression, const Location &where) const;
  /// What an option or attribute has been set to, or null.
  const Parameter *findSetting(std::string_view name) const;

  void addTexture(TextureUse texture, RibArguments &arguments);
  /// A colour of as many samples as ColorSamples has stated.
  Vec3d readColor(RibArguments &arguments, const char *what);

  void open(Block kind, const RibArguments &arguments);
  void close(Block kind, const char *name, const RibArguments &arguments);
  bool inWorld() const;
  void concatenate(const Matrix4 &matrix) { state.transform = matrix * state.transform; }
  /// The shader that a request names: an index into the scene's, or -1 for "null" and "".
  int addShader(ShaderKind kind, RibArguments &arguments);
  /// The light that a request names: an index into the scene's.
  uint32_t addLight(RibArguments &arguments);
  /// Adds a shape with its variables. Throws ShapeError where there is something wrong with them.
  void addShape(ShapeGeometry geometry, ParameterList variables, const VariableCounts &counts,
                RibArguments &arguments);
  void addPolygons(PolygonShape shape, ParameterList variables, RibArguments &arguments);
  void addPatches(PatchShape shape, RibArguments &arguments);
  /// `hasTexts`: tags have texts besides numbers.
  void addSubdivision(RibArguments &arguments, bool hasTexts);
  void addQuadric(QuadricShape shape, RibArguments &arguments);
  static bool isQuiet(std::string_view group);
  /// How deep rays go that shaders trace, of an Option or Attribute; whether that is what it says.
  bool setDepth(std::string_view name, const Parameter &parameter);
  /// Warns once that a name of an option, attribute or parameter means nothing here.
  void warnUnknown(const char *what, const std::string &name, const Location &where);

  std::filesystem::path sceneFile;
  Warnings &warnings;
  std::map<std::string, Declaration, std::less<>> declarations;
  GraphicsState state;
  std::vector<GraphicsState> savedStates;
  SceneDescription scene;
  std::vector<SceneDescription> savedScenes; ///< options before FrameBegin and WorldBegin
  std::vector<OpenBlock> blocks;
  size_t blockFloor = 0; ///< blocks that the archive or object being read may not close
  std::map<std::string, uint32_t, std::less<>> lightHandles;

  std::optional<OpenRecording> recording;
  std::map<std::string, Recording, std::less<>> objects, archives;
  std::vector<double> motionTimes;
  std::vector<Condition> conditions;
  std::vector<std::filesystem::path> openArchives;
  std::vector<Recording> openReplays;
  double frame = 0;
  double detailFactor = 1;
  std::vector<double> colorToRgb; ///< three numbers for each sample of a colour; empty: it is RGB
  std::vector<TextureUse> firstTextures; ///< made before the first picture
  std::vector<SceneDescription> finished;
};

} // namespace anysl::render

#endif
