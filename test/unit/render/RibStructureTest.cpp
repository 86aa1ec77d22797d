//===-- test/unit/render/RibStructureTest.cpp - objects, archives, conditions, motion ---------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibReader.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace anysl::render;

namespace {

std::vector<SceneDescription> read(const std::string &text, bool keepGoing = false) {
  auto file = std::make_shared<SourceFile>();
  file->name = "scene.rib";
  file->text = text;
  Warnings warnings(nullptr);
  warnings.keepGoing = keepGoing;
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

/// How many shapes the body of a world makes.
size_t shapesOf(const std::string &body) {
  return read("WorldBegin " + body + " WorldEnd").at(0).shapes.size();
}

/// Where a transformation takes a point.
Vec3d moved(const std::string &transformation, Vec3d p) {
  auto scene = read("WorldBegin " + transformation + " CoordinateSystem \"x\" WorldEnd").at(0);
  return scene.spaces.at("x").point(p);
}

bool near(Vec3d a, Vec3d b) { return maxAbs(a - b) < 1e-12; }

const std::string ball = " Sphere 1 -1 1 360 ";

using Catch::StartsWith;

} // namespace

TEST_CASE("an object is drawn where it is named, with the attributes there", "[rib]") {
  auto scene =
      read("ObjectBegin 1 Translate 0 0 1" + ball +
           "ObjectEnd WorldBegin ObjectBegin \"two\" "
           "ObjectInstance 1 Translate 0 5 0 ObjectInstance 1 ObjectEnd "
           "Color 1 0 0 Translate 3 0 0 ObjectInstance 1 Color 0 1 0 ObjectInstance [\"two\"]" +
           ball + "WorldEnd")
          .at(0);
  REQUIRE(scene.shapes.size() == 4);
  auto at = [&](size_t i) { return scene.shapes[i].objectToCamera.point({0, 0, 0}); };
  auto color = [&](size_t i) { return scene.appearances.at(scene.shapes[i].appearance).color; };
  CHECK(at(0) == Vec3d(3, 0, 1));
  CHECK(color(0) == Vec3d(1, 0, 0));
  CHECK(at(1) == Vec3d(3, 0, 1));
  CHECK(at(2) == Vec3d(3, 5, 1)); // the first one's Translate is undone
  CHECK(color(2) == Vec3d(0, 1, 0));
  CHECK(at(3) == Vec3d(3, 0, 0)); // and so is all that the object does
}

TEST_CASE("objects and archives that make no sense are refused", "[rib]") {
  CHECK_THAT(errorOf("WorldBegin ObjectInstance 3 WorldEnd"),
             StartsWith("scene.rib:1:12: error: ObjectInstance: there is no object 3"));
  CHECK_THAT(errorOf("ObjectBegin 1 Color 1 1 1"),
             StartsWith("scene.rib:1:1: error: ObjectBegin without its end"));
  CHECK_THAT(errorOf("ObjectEnd"),
             StartsWith("scene.rib:1:1: error: ObjectEnd without ObjectBegin"));
  CHECK_THAT(errorOf("ObjectBegin 1 ObjectEnd ObjectBegin 1 ObjectInstance 1 ObjectEnd "
                     "WorldBegin ObjectInstance 1"),
             StartsWith("scene.rib:1:39: error: an object or archive that holds itself"));
  CHECK_THAT(errorOf("ObjectBegin 1 AttributeEnd ObjectEnd WorldBegin AttributeBegin "
                     "ObjectInstance 1 WorldEnd"),
             StartsWith("scene.rib:1:15: error: AttributeEnd does not match the open block"));
  CHECK_THAT(errorOf("ObjectBegin 1 AttributeBegin ObjectEnd WorldBegin ObjectInstance 1 WorldEnd"),
             StartsWith("scene.rib:1:15: error: a block that is not closed in its object"));
  CHECK_THAT(errorOf("ReadArchive \"nowhere.rib\""),
             StartsWith("scene.rib:1:1: error: archive \"nowhere.rib\" is not found in"));
}

TEST_CASE("an archive of the file's own changes the state where it is read", "[rib]") {
  auto scene = read("ArchiveBegin \"a\" Color 0 0 1 Translate 1 0 0" + ball +
                    "ArchiveEnd WorldBegin ReadArchive \"a\" ReadArchive \"a\" WorldEnd")
                   .at(0);
  REQUIRE(scene.shapes.size() == 2);
  CHECK(scene.shapes[1].objectToCamera.point({0, 0, 0}) == Vec3d(2, 0, 0));
  CHECK(scene.appearances.at(scene.shapes[1].appearance).color == Vec3d(0, 0, 1));
}

TEST_CASE("conditions look at options, attributes and the frame", "[rib]") {
  const std::string before = "Attribute \"user\" \"string pass\" [\"beauty\"] \"float size\" 3 ";
  auto holds = [&](const std::string &condition) {
    size_t drawn =
        shapesOf(before + "IfBegin \"" + condition + "\"" + ball + ball + "Else" + ball + "IfEnd");
    REQUIRE((drawn == 1 || drawn == 2));
    return drawn == 2;
  };
  for (const char *yes : {"1", "$user:pass == 'beauty'", "$size > 2 && $size <= 3", "!($size < 2)",
                          "$pass != 'shadow'", "$size * 2 - 1 == 10 / 2", "0 || -1",
                          "defined(user:size) && !defined($other)", "${user:size} == 3",
                          "$Frame == 0", "$other == 0", "$pass < 'c'", "1 + 2 * 3 == 7"})
    CHECK(holds(yes));
  for (const char *no : {"0", "$pass == 'shadow'", "$size > 3", "$other", "!$pass", "$pass == 3"})
    CHECK_FALSE(holds(no));
  CHECK(shapesOf("IfBegin \"0\" Nonsense 1" + ball + "IfBegin \"1\"" + ball + "Else" + ball +
                 "IfEnd ElseIf \"1\"" + ball + "ElseIf \"1\"" + ball + ball + "Else" + ball + ball +
                 ball + "IfEnd") == 1);
  CHECK(read("FrameBegin 7 WorldBegin IfBegin \"$Frame == 7\"" + ball + "IfEnd WorldEnd FrameEnd")
            .at(0)
            .shapes.size() == 1);
}

TEST_CASE("conditions that are none", "[rib]") {
  auto error = [](const std::string &condition) {
    return errorOf("WorldBegin IfBegin \"" + condition + "\" IfEnd WorldEnd");
  };
  const std::string place = "scene.rib:1:12: error: condition: ";
  CHECK_THAT(error(""), StartsWith(place + "something is missing at its end"));
  CHECK_THAT(error("(1"), StartsWith(place + "a ')' is missing"));
  CHECK_THAT(error("1 2"), StartsWith(place + "'2' is not understood"));
  CHECK_THAT(error("$"), StartsWith(place + "a variable's name is missing"));
  CHECK_THAT(error("'x"), StartsWith(place + "a text without its closing quote"));
  CHECK_THAT(error("x"), StartsWith(place + "'x' is no value"));
  CHECK_THAT(error(std::string(5000, '!')), StartsWith(place + "it is nested too deeply"));
  CHECK_THAT(error(std::string(5000, '(')), StartsWith(place + "it is nested too deeply"));
  CHECK_THAT(errorOf("WorldBegin IfBegin \"1\" WorldEnd"),
             StartsWith("scene.rib:1:12: error: IfBegin without its end"));
  CHECK_THAT(errorOf("Else"), StartsWith("scene.rib:1:1: error: Else without IfBegin"));
  CHECK_THAT(errorOf("ElseIf \"1\""), StartsWith("scene.rib:1:1: error: ElseIf without IfBegin"));
  CHECK_THAT(errorOf("IfEnd"), StartsWith("scene.rib:1:1: error: IfEnd without IfBegin"));
}

TEST_CASE("what moves stands where it is when the shutter opens", "[rib]") {
  auto x = [](const std::string &shutter) {
    return read("Shutter " + shutter +
                " WorldBegin MotionBegin [0 2 3] Translate 0 0 0 Translate 4 0 0 "
                "Translate 8 0 0 MotionEnd" +
                ball + "WorldEnd")
        .at(0)
        .shapes.at(0)
        .objectToCamera.point({0, 0, 0})
        .x;
  };
  CHECK(x("0 0") == 0);
  CHECK(x("-1 1") == 0);
  CHECK(x("0.5 1") == 1);
  CHECK(x("2.5 3") == 6);
  CHECK(x("9 9") == 8);
  // Numbers one by one, and requests that do not fit each other.
  CHECK(shapesOf("MotionBegin 0 1 Sphere 1 -1 1 360 Sphere 2 -2 2 360 MotionEnd") == 1);
  CHECK(shapesOf("MotionBegin [0 1] Sphere 1 -1 1 360 Disk 0 1 360 MotionEnd") == 1);
  CHECK_THAT(errorOf("MotionBegin [0 1] Translate 0 0 0 MotionEnd"),
             StartsWith("scene.rib:1:1: error: MotionBegin states 2 times, but 1 requests follow"));
  CHECK_THAT(errorOf("MotionBegin [] MotionEnd"),
             StartsWith("scene.rib:1:1: error: MotionBegin: no times are given"));
  CHECK_THAT(errorOf("MotionEnd"),
             StartsWith("scene.rib:1:1: error: MotionEnd without MotionBegin"));
}

TEST_CASE("skewing turns one direction towards another", "[rib]") {
  // y towards x by 45 degrees: x' = x + y.
  CHECK(near(moved("Skew 45 0 1 0 1 0 0", {2, 3, 4}), {5, 3, 4}));
  CHECK(near(moved("Skew [-45 0 1 0 1 0 0]", {2, 3, 4}), {-1, 3, 4}));
  // The lines along which points move need not be perpendicular to the direction that turns.
  Vec3d turned = moved("Skew 15 0 1 0 1 1 0", {0, 1, 0});
  CHECK(std::atan2(turned.x, turned.y) == Approx(15 * std::numbers::pi / 180));
  CHECK_THAT(errorOf("Skew 90 0 1 0 1 0 0"), StartsWith("scene.rib:1:1: error: Skew: the angle"));
  CHECK_THAT(errorOf("Skew 9 0 1 0 0 1 0"), StartsWith("scene.rib:1:1: error: Skew: the angle"));
}

TEST_CASE("a perspective puts distance 1 to depth 0 and scales by distance", "[rib]") {
  CHECK(near(moved("Perspective 90", {1, 2, 1}), {1, 2, 0}));
  CHECK(near(moved("Perspective 90", {1, 2, 4}), {0.25, 0.5, 0.75}));
  CHECK_THAT(errorOf("Perspective 180"), StartsWith("scene.rib:1:1: error: Perspective"));
}

TEST_CASE("coordinate systems are come back to by their names", "[rib]") {
  const std::string begin = "Translate 0 0 9 CoordinateSystem \"desk\" Scale 2 2 2 ";
  auto scene = read("Translate 0 0 7 WorldBegin " + begin +
                    "CoordSysTransform \"desk\" CoordinateSystem "
                    "\"a\" CoordSysTransform \"world\" CoordinateSystem \"b\" CoordSysTransform "
                    "\"camera\" ScopedCoordinateSystem \"c\" WorldEnd")
                   .at(0);
  auto at = [&](const char *name) { return scene.spaces.at(name).point({1, 0, 0}); };
  CHECK(at("a") == Vec3d(1, 0, 16));
  CHECK(at("b") == Vec3d(1, 0, 7));
  CHECK(at("c") == Vec3d(1, 0, 0));
  CHECK_THAT(errorOf("CoordSysTransform \"x\""),
             StartsWith("scene.rib:1:1: error: there is no coordinate system \"x\""));
}

TEST_CASE("solids are drawn as they are", "[rib]") {
  CHECK(shapesOf("SolidBegin \"difference\" SolidBegin \"primitive\"" + ball + "SolidEnd" + ball +
                 "SolidEnd") == 2);
  CHECK_THAT(errorOf("SolidBegin \"primitive\" AttributeEnd"),
             StartsWith("scene.rib:1:24: error: AttributeEnd does not match"));
}

TEST_CASE("what is wrong can be left out", "[rib]") {
  auto scene = read("WorldBegin Sphere 1 Color 1 [2 3] ReadArchive \"nowhere\" ObjectInstance 9" +
                        ball + "WorldEnd",
                    true)
                   .at(0);
  CHECK(scene.shapes.size() == 1);
}

TEST_CASE("colours of other samples become RGB", "[rib]") {
  // Two samples: the first is red, the second half green and blue.
  auto scene =
      read("ColorSamples [1 0 0 0 0.5 1] [1 0 0 1 0 0] WorldBegin Color [0.25 0.5] Opacity 1 "
           "1" +
           ball + "WorldEnd")
          .at(0);
  CHECK(scene.appearances.at(0).color == Vec3d(0.25, 0.25, 0.5));
  CHECK(scene.appearances.at(0).opacity == Vec3d(1, 0.5, 1));
  CHECK_THAT(errorOf("ColorSamples [1 2] [1 2]"),
             StartsWith("scene.rib:1:1: error: ColorSamples: three numbers"));
}

TEST_CASE("of several details the one is drawn that fits its size on the picture", "[rib]") {
  // A square of side 1 at depth 10, seen at 90 degrees in 200 pixels: 10 x 10 pixels.
  const std::string camera = "Format 200 200 1 Projection \"perspective\" \"fov\" 90 ";
  auto drawn = [&](const std::string &factor, const std::string &range) {
    return read(camera + factor + "WorldBegin Translate 0 0 10 Detail [0 1 0 1 0 0] DetailRange [" +
                range + "]" + ball + "WorldEnd")
               .at(0)
               .shapes.size() == 1;
  };
  CHECK(drawn("", "0 0 1000 1000"));
  CHECK(drawn("", "90 90 110 110"));
  CHECK_FALSE(drawn("", "0 0 90 90"));
  CHECK_FALSE(drawn("", "110 110 1e38 1e38"));
  CHECK(drawn("", "90 105 200 200")); // more than half of the way there
  CHECK_FALSE(drawn("RelativeDetail 0.5 ", "90 90 110 110"));
  CHECK(drawn("RelativeDetail 0.5 ", "0 0 90 90"));
  // A bound around the camera is as large as can be; without a bound everything is drawn.
  CHECK(read(camera + "WorldBegin Detail [-1 1 -1 1 -1 1] DetailRange [1000 1000 1e38 1e38]" +
             ball + "WorldEnd")
            .at(0)
            .shapes.size() == 1);
  CHECK(read(camera + "WorldBegin DetailRange [0 0 1 1]" + ball + "WorldEnd").at(0).shapes.size() ==
        1);
}

TEST_CASE("a lens is stated by f-stop, focal length and focal distance", "[rib]") {
  auto camera = [](const std::string &text) {
    return read(text + " WorldBegin WorldEnd").at(0).camera;
  };
  CHECK(camera("DepthOfField 2 0.5 7").lensRadius == 0.125);
  CHECK(camera("DepthOfField [2 0.5 7]").focalDistance == 7);
  CHECK(camera("DepthOfField 2 0.5 7 DepthOfField").lensRadius == 0);
  CHECK(camera("DepthOfField 1e38 0.5 7").lensRadius == 0);
  CHECK_THAT(errorOf("DepthOfField 0 1 1"), StartsWith("scene.rib:1:1: error: DepthOfField"));
}

TEST_CASE("what is beside the point or unknown does not end the reading", "[rib]") {
  auto camera = [](const std::string &text) {
    return read(text + " WorldBegin WorldEnd").at(0).camera;
  };
  CHECK(camera("Projection \"fisheye\"").perspective);
  CHECK_FALSE(camera("Projection \"orthographic\"").perspective);
  CHECK(camera("Format 100 50 1 Format -1 -1 -1").width == 640);
}
