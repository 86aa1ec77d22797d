//===-- lib/Rib/SceneDescription.h - a scene as the file states it ----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a reader of scene files produces and the renderer consumes: plain data, no file format and
// no ray tracing in it. All positions are in *camera space*, the shaders' "current" space: the eye
// is at the origin and looks along +z, x is right, y is up. So coordinates are most exact where
// they are seen from near, however far from the world's origin the camera stands.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_SCENEDESCRIPTION_H
#define ANYSL_LIB_RIB_SCENEDESCRIPTION_H

#include "lib/Rib/Basis.h"
#include "lib/Rib/Diagnostics.h"
#include "lib/Rib/Linear.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace anysl::render {

enum class StorageClass { Constant, Uniform, Varying, Vertex, FaceVarying };
enum class ValueType { Float, Color, Point, Vector, Normal, HPoint, Matrix, String };

/// How many numbers a value of the type has; 1 for a string.
unsigned componentCount(ValueType type);

/// "uniform color[2]": what Declare or an inline declaration says about a name.
struct Declaration {
  StorageClass storage = StorageClass::Uniform;
  ValueType type = ValueType::Float;
  unsigned arrayLength = 0; ///< 0: not an array
};

/// A name with its values, as in "Kd" [0.5].
struct Parameter {
  std::string name;
  std::optional<Declaration> declaration;
  std::vector<double> numbers; ///< one of these two is empty
  std::vector<std::string> strings;
  Location where;
};
using ParameterList = std::vector<Parameter>;

const Parameter *findParameter(const ParameterList &list, std::string_view name);

/// Options or attributes by their full names, as in "searchpath:shader".
using ParameterMap = std::map<std::string, Parameter, std::less<>>;

/// The kinds of shader, with the numbers that shader libraries have for them; a co-shader may be of
/// any.
enum class ShaderKind { Any = 0, Surface = 1, Displacement, Light, Volume, Imager };

/// A shader as a request such as Surface names it.
struct ShaderUse {
  ShaderKind kind = ShaderKind::Surface;
  std::string name;
  ParameterList parameters;
  Matrix4 shaderToCamera = Matrix4::identity();
  Location where;
  /// The use that this one is with values of a shape's own; null: none.
  const ShaderUse *variantOf = nullptr;
};

/// Which rays see a surface.
struct Visibility {
  bool camera = true;
  bool specular = true, diffuse = true; ///< those that shaders trace
  /// What stops light on its way through: all of it, a part as its opacity or its shader says,
  /// none.
  enum Transmission { Opaque, ByOpacity, ByShader, Transparent } transmission = ByOpacity;
  friend bool operator==(const Visibility &, const Visibility &) = default;
};

/// Everything about a surface that is not its shape.
struct Appearance {
  /// Indices into SceneDescription::shaders, or -1: none, and for the surface the built-in one.
  int surface = -1, displacement = -1, atmosphere = -1, interior = -1, exterior = -1;
  Vec3d color{1, 1, 1};
  Vec3d opacity{1, 1, 1};
  bool reverseOrientation = false;
  bool matte = false; ///< to the camera it hides what is behind, and is transparent itself
  int sides = 2;
  double shadingRate = 1; ///< size of displaced facets, in square pixels
  Visibility visibility;
  std::vector<std::string> sets; ///< that it is a member of, for rays that see some surfaces only
  /// How many rays for diffuse and other light may lie between the eye and what such rays meet that
  /// start here.
  unsigned maxDiffuseDepth = 1, maxSpecularDepth = 64;
  std::vector<uint32_t> lights; ///< those that shine on it: indices into SceneDescription::lights
  std::array<double, 8> textureCoordinates{0, 0, 1, 0, 0, 1, 1, 1}; ///< s t at the (u, v) corners
  /// What Attribute has stated, known here or not; null: nothing.
  std::shared_ptr<const ParameterMap> attributes;
  /// Co-shaders by handle: indices into SceneDescription::shaders; null: none.
  std::shared_ptr<const std::map<std::string, int, std::less<>>> coshaders;
  friend bool operator==(const Appearance &, const Appearance &) = default;
};

/// A surface swept about the z axis, in the words of the RenderMan Interface.
struct QuadricShape {
  enum Kind { Sphere, Cone, Cylinder, Hyperboloid, Paraboloid, Disk, Torus } kind = Sphere;
  double radius = 1; ///< of the torus: the major one
  double zmin = 0, zmax = 0, height = 0;
  double minorRadius = 0, phiMin = 0, phiMax = 360; ///< torus only
  Vec3d point1, point2;                             ///< hyperboloid only
  double thetaMax = 360;
};

/// Polygons that share their vertices, with holes.
struct PolygonShape {
  std::vector<uint32_t> loopCounts;   ///< of each polygon: its outline and its holes
  std::vector<uint32_t> vertexCounts; ///< of each loop
  std::vector<uint32_t> vertices;     ///< of all loops: indices into the positions
};

/// The faces of a smooth mesh that are drawn: the others only shape those beside them.
struct DrawnFaces {
  std::vector<uint32_t> faces; ///< in increasing order; empty: all
  bool contain(uint32_t face) const {
    return faces.empty() || std::binary_search(faces.begin(), faces.end(), face);
  }
};

/// Bilinear or bicubic patches that share their control points, the points of a row in u together.
struct PatchShape {
  struct Direction {
    Basis basis = Basis::bezier;
    uint32_t count = 0; ///< control points
    bool wraps = false; ///< the last ones are followed by the first
    uint32_t segments(bool cubic) const;
  };
  bool cubic = false;
  Direction u, v;
  DrawnFaces drawn = {}; ///< patches, row by row
};

/// A non-uniform rational B-spline surface.
struct NurbsShape {
  struct Direction {
    uint32_t count = 0, order = 0; ///< control points; degree + 1
    std::vector<double> knots;     ///< count + order
    double min = 0, max = 1;       ///< the part that is drawn
    uint32_t segments() const { return count - order + 1; }
  };
  /// A curve in the surface's parameters, as the knots count them.
  struct TrimCurve {
    Direction direction;
    std::vector<std::array<double, 3>> points; ///< u and v times their weight, and the weight
  };
  using TrimLoop = std::vector<TrimCurve>; ///< closed: each curve ends where the next one begins
  Direction u, v;
  /// What lies within an odd number of these is there, or what does not; null: all is.
  std::shared_ptr<const std::vector<TrimLoop>> trims = nullptr;
  bool isOutsideTrims = false;
  DrawnFaces drawn = {}; ///< segments, row by row
};

/// A Catmull-Clark surface.
struct SubdivisionShape {
  /// At most so many corners may a face have, and so many faces meet at a vertex.
  static constexpr uint32_t mostCorners = 16, mostFaces = 64;
  std::vector<uint32_t> vertexCounts; ///< of each face
  std::vector<uint32_t> vertices;     ///< of all faces: indices into the positions
  enum class Boundary {
    None,            ///< the surface ends where a vertex is not surrounded by faces
    EdgesAndCorners, ///< it goes to the boundary, and through a vertex of one face
    Edges,           ///< it goes to the boundary, which is smooth
  } boundary = Boundary::None;
  struct Crease {
    uint32_t a, b;
    double sharpness; ///< may be infinite
  };
  std::vector<Crease> creases;
  struct Corner {
    uint32_t vertex;
    double sharpness;
  };
  std::vector<Corner> corners;
  std::vector<uint32_t> holes; ///< faces that are not there
  DrawnFaces drawn = {};
};

/// Ribbons along curves.
struct CurvesShape {
  bool cubic = false, wraps = false;
  Basis basis = Basis::bezier;
  std::vector<uint32_t> counts; ///< vertices of each curve
  /// How many segments so many vertices make; 0: they do not fit.
  uint32_t segments(uint32_t count) const;
};

/// Particles at the positions.
struct PointsShape {};

using ShapeGeometry = std::variant<QuadricShape, PolygonShape, PatchShape, NurbsShape,
                                   SubdivisionShape, CurvesShape, PointsShape>;

struct Shape {
  ShapeGeometry geometry;
  ParameterList variables; ///< of every class, each with its declaration and as many values as fit
  Matrix4 objectToCamera = Matrix4::identity();
  uint32_t appearance = 0;
  Location where;
};

struct LightUse {
  std::string name;
  std::string handle; ///< by which shaders know it
  ParameterList parameters;
  Matrix4 lightToCamera = Matrix4::identity();
  bool castsShadow = true;
  std::vector<uint32_t> shapes; ///< of an area light: indices into SceneDescription::shapes
  Location where;
};

/// What a file shows: "rgb", "a" (coverage), "z" (depth), a shader's global variable or output.
struct OutputVariable {
  std::string name;
  std::optional<Declaration> declaration;
};

struct OutputFile {
  std::string name;   ///< as given; the type follows from its suffix, else from `format`
  std::string format; ///< "file", "png", "openexr", ...
  std::vector<OutputVariable> variables;
  bool isReplacement = false; ///< of a window: not needed where there is a file
  bool half = false;          ///< 16 bits a channel where the format has such floats
  Location where;
};

enum class FilterKind { Box, Triangle, Gaussian, CatmullRom, Sinc, Mitchell, BlackmanHarris, Disk };

struct CameraDescription {
  bool perspective = false;
  double fov = 90; ///< degrees across the smaller side of the screen window [-1, 1]
  int width = 640, height = 480;
  double pixelAspect = 1;
  double frameAspect = 0; ///< 0: from the format
  std::optional<std::array<double, 4>> screenWindow;
  std::array<double, 4> cropWindow{0, 1, 0, 1};
  double nearClip = 1e-10, farClip = 1e38;
  double lensRadius = 0, focalDistance = 0; ///< 0: all distances are sharp
  double shutterOpen = 0, shutterClose = 0;
};

/// The light that comes from beyond all surfaces.
struct BackgroundDescription {
  bool visible = false; ///< some option asks for one; otherwise black and transparent
  Vec3d zenith, horizon, ground;
};

/// A file of the scene's that is to be made from others: MakeTexture and its like.
struct TextureUse {
  enum Kind { Texture, LatLong, CubeFaces, Shadow } kind = Texture;
  std::vector<std::string> pictures; ///< six of a cube: px nx py ny pz nz
  std::string texture;
  std::string wrapS = "periodic", wrapT = "periodic";
  double fov = 90; ///< of a cube's faces
  Location where;
};

struct SceneDescription {
  CameraDescription camera;
  int samplesX = 2, samplesY = 2;
  bool jitter = true; ///< samples lie anywhere in their cells, not in the middle
  FilterKind filter = FilterKind::Gaussian;
  double filterWidthX = 2, filterWidthY = 2;
  double gain = 1, gamma = 1;
  double quantizeOne = 255; ///< the integer that stands for 1 in files; 0: floats where they can be
  unsigned maxDepth = 8;
  BackgroundDescription background;
  std::string folder;     ///< of the scene's file, where relative names of textures begin
  std::string shaderPath; ///< colon-separated; & stands for the default
  std::vector<OutputFile> outputs;
  /// Textures that are to be made before and after the picture is rendered.
  std::vector<TextureUse> texturesBefore, texturesAfter;
  std::vector<std::string> archives; ///< files that belong to the scene besides its own
  ParameterMap options;              ///< what Option has stated, known here or not
  int imager = -1;                   ///< index into shaders, or -1

  Matrix4 worldToCamera = Matrix4::identity();
  std::map<std::string, Matrix4, std::less<>> spaces; ///< CoordinateSystem: to camera space
  std::vector<ShaderUse> shaders;
  std::vector<LightUse> lights;
  std::vector<Appearance> appearances;
  std::vector<Shape> shapes;
};

/// A name in a list of sets, and the sign before it: '+', '-', or 0.
struct SetName {
  char sign;
  std::string_view name;
};
/// Takes the first name off a list such as "a,+b,-c"; between two separators it is empty.
SetName takeSetName(std::string_view &list);

} // namespace anysl::render

#endif
