//===-- test/unit/render/RibTest.cpp - scene files
//---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibReader.h"
#include "lib/Rib/RibState.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {

std::vector<SceneDescription> read(const std::string &text) {
  auto file = std::make_shared<SourceFile>();
  file->name = "scene.rib";
  file->text = text;
  Warnings warnings;
  return readRib(file, warnings);
}

std::string errorOf(const std::string &text) {
  try {
    read(text);
  } catch (const UserError &error) {
    return error.what();
  }
  return "no error";
}

using Catch::StartsWith;

} // namespace

TEST_CASE("numbers, strings, comments and arrays are read as RIB writes them", "[rib]") {
  auto scene =
      read("# a comment\n##RenderMan RIB\nFormat 32 +16 .5e1 WorldBegin # more\n"
           "Surface \"a\\\"b\\n\\101\" \"x\"[-1 .25 1e2 1e-400]\"y\" [\"p\" \"q\"] WorldEnd")
          .at(0);
  CHECK(scene.camera.width == 32);
  CHECK(scene.camera.height == 16);
  CHECK(scene.camera.pixelAspect == 5);
  const ShaderUse &surface = scene.shaders.at(0);
  CHECK(surface.name == "a\"b\nA");
  CHECK(surface.parameters.at(0).numbers == std::vector<double>{-1, 0.25, 100, 0});
  CHECK(surface.parameters.at(1).strings == std::vector<std::string>{"p", "q"});
}

TEST_CASE("declarations are read inline and from Declare", "[rib]") {
  auto scene = read("Declare \"warmth\" \"varying color[2]\" WorldBegin Surface \"s\" "
                    "\"uniform point at\" [1 2 3] \"warmth\" [1 2 3 4 5 6] \"plain\" 7 WorldEnd")
                   .at(0);
  const ParameterList &list = scene.shaders.at(0).parameters;
  CHECK(list.at(0).name == "at");
  CHECK(list.at(0).declaration->type == ValueType::Point);
  CHECK(list.at(1).declaration->storage == StorageClass::Varying);
  CHECK(list.at(1).declaration->type == ValueType::Color);
  CHECK(list.at(1).declaration->arrayLength == 2);
  CHECK_FALSE(list.at(2).declaration);
  CHECK(list.at(2).numbers == std::vector<double>{7});
}

TEST_CASE("a transformation applies to what follows, nearest first", "[rib]") {
  auto scene = read("Translate 0 0 10 WorldBegin Translate 1 0 0 Scale 2 2 2 TransformBegin "
                    "CoordinateSystem \"here\" Rotate 90 0 0 1 Sphere 1 -1 1 360 TransformEnd "
                    "Sphere 1 -1 1 360 Identity Sphere 1 -1 1 360 Transform [1 0 0 0 0 1 0 0 0 0 1 "
                    "0 5 6 7 1] "
                    "Sphere 1 -1 1 360 WorldEnd")
                   .at(0);
  auto at = [&](size_t shape, Vec3d p) { return scene.shapes.at(shape).objectToCamera.point(p); };
  CHECK(maxAbs(at(0, {1, 0, 0}) - Vec3d(1, 2, 10)) < 1e-12);
  CHECK(at(1, {1, 0, 0}) == Vec3d(3, 0, 10));
  CHECK(at(2, {1, 0, 0}) == Vec3d(1, 0, 10)); // Identity means the world's space
  CHECK(at(3, {0, 0, 0}) == Vec3d(5, 6, 17));
  CHECK(scene.spaces.at("here").point({1, 0, 0}) == Vec3d(3, 0, 10));
}

TEST_CASE("attributes are saved and restored", "[rib]") {
  auto scene = read("WorldBegin LightSource \"pointlight\" 1 LightSource \"distantlight\" \"sun\" "
                    "Color 1 0 0 "
                    "AttributeBegin Color [0 1 0] Illuminate 1 0 ReverseOrientation Sphere 1 -1 1 "
                    "360 AttributeEnd "
                    "Sphere 1 -1 1 360 WorldEnd")
                   .at(0);
  const Appearance &inner = scene.appearances.at(scene.shapes.at(0).appearance);
  const Appearance &outer = scene.appearances.at(scene.shapes.at(1).appearance);
  CHECK(inner.color == Vec3d(0, 1, 0));
  CHECK(inner.lights == std::vector<uint32_t>{1});
  CHECK(inner.reverseOrientation);
  CHECK(outer.color == Vec3d(1, 0, 0));
  CHECK(outer.lights == std::vector<uint32_t>{0, 1});
  CHECK_FALSE(outer.reverseOrientation);
}

TEST_CASE("shaders of every kind, options and attributes are kept as they are stated", "[rib]") {
  auto scene =
      read("Imager \"background\" \"bgcolor\" [1 0 0] Option \"user\" \"float size\" 3 "
           "WorldBegin Atmosphere \"fog\" AttributeBegin Attribute \"user\" \"string tag\" "
           "[\"a\"] Displacement \"dents\" Surface \"null\" Interior \"smoke\" "
           "Exterior \"air\" Sphere 1 -1 1 360 AttributeEnd Sphere 1 -1 1 360 WorldEnd")
          .at(0);
  auto name = [&](int index) { return index < 0 ? "none" : scene.shaders.at(size_t(index)).name; };
  const Appearance &inner = scene.appearances.at(scene.shapes.at(0).appearance);
  const Appearance &outer = scene.appearances.at(scene.shapes.at(1).appearance);
  CHECK(name(scene.imager) == "background");
  CHECK(name(inner.atmosphere) == "fog");
  CHECK(name(outer.atmosphere) == "fog");
  CHECK(name(inner.displacement) == "dents");
  CHECK(name(outer.displacement) == "none");
  CHECK(name(inner.surface) == "none");
  CHECK(name(inner.interior) == "smoke");
  CHECK(name(inner.exterior) == "air");
  CHECK(scene.options.at("user:size").numbers == std::vector<double>{3});
  CHECK(inner.attributes->at("user:tag").strings == std::vector<std::string>{"a"});
  CHECK_FALSE(outer.attributes);
}

TEST_CASE("each world of a file is a scene, and frames restore options", "[rib]") {
  auto scenes = read("Format 10 10 1 FrameBegin 1 Format 20 20 1 Display \"a.png\" \"file\" "
                     "\"rgb\" WorldBegin WorldEnd "
                     "FrameEnd FrameBegin 2 Display \"b.png\" \"file\" \"rgba\" Display \"+b.exr\" "
                     "\"openexr\" \"rgba\" "
                     "WorldBegin WorldEnd FrameEnd");
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].camera.width == 20);
  CHECK(scenes[1].camera.width == 10);
  CHECK(scenes[0].outputs.size() == 1);
  REQUIRE(scenes[1].outputs.size() == 2);
  CHECK(scenes[1].outputs[1].name == "b.exr");
  CHECK(scenes[1].outputs[1].variables.at(1).name == "a");
}

TEST_CASE("orientations count from the handedness of the space", "[rib]") {
  auto scene =
      read("WorldBegin Orientation \"rh\" Sphere 1 -1 1 360 Scale -1 1 1 Orientation \"rh\" "
           "Sphere 1 -1 1 360 Orientation \"inside\" Sphere 1 -1 1 360 WorldEnd")
          .at(0);
  auto reversed = [&](size_t shape) {
    return scene.appearances.at(scene.shapes.at(shape).appearance).reverseOrientation;
  };
  CHECK(reversed(0));
  CHECK_FALSE(reversed(1));
  CHECK(reversed(2));
}

TEST_CASE("what cannot be understood is refused with its place", "[rib]") {
  CHECK_THAT(errorOf("WorldBegin\n  Sphere 1 -1 x\nWorldEnd"),
             StartsWith("scene.rib:2:3: error: Sphere: radius, zmin, zmax and sweep is missing"));
  CHECK_THAT(
      errorOf("WorldBegin Sphere 1 -1 \"1\" 360 WorldEnd"),
      StartsWith(
          "scene.rib:1:24: error: Sphere: radius, zmin, zmax and sweep: expected a number, found a "
          "string\n  WorldBegin Sphere 1 -1 \"1\" 360 WorldEnd\n                         ^\n"));
  CHECK_THAT(errorOf("Color [1 2] 3"),
             StartsWith("scene.rib:1:7: error: Color: a colour: expected 3 numbers, found 2"));
  CHECK_THAT(errorOf("Display \"x"),
             StartsWith("scene.rib:1:9: error: a string without its closing quote"));
  CHECK_THAT(errorOf("Color [1 2"),
             StartsWith("scene.rib:1:7: error: an array without its closing ']'"));
  CHECK_THAT(errorOf("Color 1 1 1]"), StartsWith("scene.rib:1:12: error: ']' without '['"));
  CHECK_THAT(errorOf("Color [1 \"2\" 3]"),
             StartsWith("scene.rib:1:10: error: an array of both numbers and strings"));
  CHECK_THAT(errorOf("Color 1.2.3 1 1"), StartsWith("scene.rib:1:7: error: this is not a number"));
  CHECK_THAT(errorOf("Color 1 1 1 1"),
             StartsWith("scene.rib:1:13: error: Color: more arguments than expected"));
  CHECK_THAT(errorOf("1 2 3"), StartsWith("scene.rib:1:1: error: expected the name of a request"));
  CHECK_THAT(errorOf("Color ;"), StartsWith("scene.rib:1:7: error: unexpected character ';'"));
  CHECK_THAT(errorOf("Surface \"s\" \"nonsense x\" 1"),
             StartsWith("scene.rib:1:13: error: \"nonsense x\" is not a declaration"));
  CHECK_THAT(errorOf("Surface \"s\" \"Kd\""),
             StartsWith("scene.rib:1:13: error: Surface: parameter \"Kd\" has no value"));
}

TEST_CASE("blocks have to match", "[rib]") {
  CHECK_THAT(errorOf("WorldBegin AttributeBegin"),
             StartsWith("scene.rib:1:12: error: AttributeBegin without its end"));
  CHECK_THAT(errorOf("WorldBegin AttributeBegin WorldEnd"),
             StartsWith("scene.rib:1:27: error: WorldEnd does not match the open block"));
  CHECK_THAT(errorOf("Sphere 1 -1 1 360"),
             StartsWith("scene.rib:1:1: error: a shape outside WorldBegin ... WorldEnd"));
  CHECK_THAT(errorOf("Format 1 1 1"),
             StartsWith("scene.rib:1:13: error: the file has no WorldBegin ... WorldEnd"));
}

TEST_CASE("polygons are checked, and wrong ones left out", "[rib]") {
  auto check = [](const std::string &polygon, const std::string &message) {
    auto file = std::make_shared<SourceFile>();
    file->name = "scene.rib";
    file->text = "WorldBegin " + polygon + " Sphere 1 -1 1 360 WorldEnd";
    Warnings warnings;
    auto scene = readRib(file, warnings).at(0);
    INFO(polygon);
    CHECK(scene.shapes.size() == 1);
    CHECK(warnings.count() == 1);
    CHECK(warnings.contains("scene.rib:1:" + message));
    CHECK(warnings.contains("; the shape is left out"));
  };
  check("Polygon", "12: warning: a polygon needs its vertices");
  check("Polygon \"P\" [0 0 0 1 1]", "20: warning: \"P\" needs 3 numbers");
  check("Polygon \"P\" [0 0 0 1 1 1]", "12: warning: a polygon needs at least 3 vertices");
  check("PointsPolygons [3] [0 1 7] \"P\" [0 0 0 1 0 0 0 1 0]",
        "12: warning: vertex 7 of 3 in \"P\"");
  check("PointsPolygons [3] [0 1] \"P\" [0 0 0 1 0 0 0 1 0]",
        "12: warning: the numbers of vertices add up to 3, but 2 vertices are given");
  check("Polygon \"P\" [0 0 0 1 0 0 0 1 0] \"st\" [0 0 1]",
        "44: warning: \"st\": expected 6 numbers, 3 varying values of 2, found 3");
  check("Polygon \"P\" [0 0 0 1 0 0 0 1 0] \"uniform string a\" [1]",
        "44: warning: \"a\" is declared as text, and this is none");
  check("GeneralPolygon [3 3] \"P\" [0 0 0 1 0 0 0 1 0]",
        "12: warning: the numbers of vertices add up to 6, but \"P\" has 3");
  check("PointsGeneralPolygons [2] [3] [0 1 2] \"P\" [0 0 0 1 0 0 0 1 0]",
        "12: warning: the numbers of loops add up to 2, but 1 numbers of vertices are given");
  CHECK_THAT(errorOf("WorldBegin PointsPolygons [3] [0 1 -2] \"P\" [0 0 0] WorldEnd"),
             StartsWith("scene.rib:1:31: error: PointsPolygons: the vertices: -2"));
}

TEST_CASE("a channel may be a standard one, also with a blank before its name", "[rib]") {
  CHECK(read("DisplayChannel \"rgb\" DisplayChannel \" a\" WorldBegin WorldEnd").size() == 1);
  auto scene =
      read("DisplayChannel \" varying color glow\" WorldBegin Surface \"s\" \"glow\" [1 2 3] "
           "WorldEnd")
          .at(0);
  CHECK(scene.shaders.at(0).parameters.at(0).declaration->type == ValueType::Color);
  CHECK_THROWS_AS(read("DisplayChannel \" varying colour glow\" WorldBegin WorldEnd"), UserError);
}

TEST_CASE("declarations that are none", "[rib]") {
  for (const char *text : {"", "uniform", "float", "uniform float", "float a b", "float[x] a",
                           "float[0] a", "float[3 a", "colour a"}) {
    std::string name;
    CHECK_THROWS_AS(parseDeclaration(text, &name, {}), UserError);
  }
}
