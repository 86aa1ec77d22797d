//===-- test/unit/render/RibBinaryTest.cpp - the binary form of RIB, and junk -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibLexer.h"
#include "lib/Rib/RibReader.h"
#include "tools/anysl-render/Sampling.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {

std::shared_ptr<SourceFile> fileOf(std::string text) {
  auto file = std::make_shared<SourceFile>();
  file->name = "scene.rib";
  file->text = std::move(text);
  return file;
}

template <size_t N>
std::string bytes(const char (&text)[N]) {
  return std::string(text, N - 1);
}

RibToken only(const std::string &text) {
  RibLexer lexer(fileOf(text));
  RibToken token = lexer.next();
  CHECK(lexer.next().kind == RibToken::End);
  return token;
}

std::string errorOf(const std::string &text) {
  RibLexer lexer(fileOf(text));
  try {
    while (lexer.next().kind != RibToken::End)
      ;
  } catch (const UserError &error) {
    return error.what();
  }
  return "no error";
}

using Catch::StartsWith;

} // namespace

TEST_CASE("binary numbers", "[rib]") {
  CHECK(only(bytes("\200\377")).number == 255);
  CHECK(only(bytes("\201\1\2")).number == 258);
  CHECK(only(bytes("\202\1\0\0")).number == 65536);
  CHECK(only(bytes("\203\377\377\377\376")).number == -2);
  CHECK(only(bytes("\204\200")).number == 0.5);              // all of it behind the point
  CHECK(only(bytes("\205\3\100")).number == 3.25);           // one byte before, one behind
  CHECK(only(bytes("\217\100\0\0\0")).number == 64);         // three behind
  CHECK(only(bytes("\244\300\40\0\0")).number == -2.5);      // IEEE float
  CHECK(only(bytes("\245\77\360\0\0\0\0\0\0")).number == 1); // IEEE double
}

TEST_CASE("binary strings, requests and arrays stand beside text", "[rib]") {
  CHECK(only(bytes("\223abc")).text == "abc");
  CHECK(only(bytes("\240\3a\"\n")).text == "a\"\n");
  CHECK(only(bytes("\241\0\1x")).text == "x");
  auto scene =
      readRib(
          fileOf(bytes("WorldBegin \314\7\227Surface\315\11\"Kd\" \314\6\"Sphere\" \246\7\223abc"
                       "\317\11\310\1\77\0\0\0 \"of\" \312\0\0\2\100\0\0\0\300\0\0\0"
                       "\246\6\200\1 -1\200\1\201\1\150 \377 WorldEnd")),
          *std::make_unique<Warnings>())
          .at(0);
  REQUIRE(scene.shaders.size() == 1);
  CHECK(scene.shaders[0].name == "abc");
  CHECK(scene.shaders[0].parameters.at(0).name == "Kd");
  CHECK(scene.shaders[0].parameters.at(0).numbers == std::vector<double>{0.5});
  CHECK(scene.shaders[0].parameters.at(1).numbers == std::vector<double>{2, -2});
  CHECK(scene.shapes.size() == 1);
}

TEST_CASE("binary words that are cut short or unknown", "[rib]") {
  CHECK_THAT(errorOf(bytes(" \203\1\2")),
             StartsWith("scene.rib:1:2: error: a binary value that the file's end cuts short"));
  CHECK_THAT(errorOf(bytes("\225abc")), StartsWith("scene.rib:1:1: error: a binary string that"));
  CHECK_THAT(errorOf(bytes("\243\377\377\377\377")),
             StartsWith("scene.rib:1:1: error: a binary string that"));
  CHECK_THAT(errorOf(bytes("\313\377\377\377\377")),
             StartsWith("scene.rib:1:1: error: a binary array that"));
  CHECK_THAT(errorOf(bytes("\246\1")),
             StartsWith("scene.rib:1:1: error: a binary request that has not been defined"));
  CHECK_THAT(errorOf(bytes("\317\1")),
             StartsWith("scene.rib:1:1: error: a binary string that has not been defined"));
  CHECK_THAT(errorOf(bytes("\314\1 Color")),
             StartsWith("scene.rib:1:1: error: a binary definition without its text"));
  CHECK_THAT(errorOf(bytes("\315\1\315\2\"x\"")),
             StartsWith("scene.rib:1:3: error: a binary definition"));
  CHECK_THAT(errorOf(bytes("\244\177\300\0\0")),
             StartsWith("scene.rib:1:1: error: this is not a number"));
  CHECK_THAT(errorOf(bytes("\310\1\177\300\0\0")),
             StartsWith("scene.rib:1:3: error: this is not a number"));
  CHECK_THAT(errorOf(bytes("\321")), StartsWith("scene.rib:1:1: error: a byte that neither"));
  CHECK_THAT(errorOf(bytes("\0")), StartsWith("scene.rib:1:1: error: a byte that neither"));
  CHECK(errorOf(std::string(1 << 20, '\377')) == "no error");
}

TEST_CASE("junk is refused or read, and nothing worse happens", "[rib]") {
  const std::string words[] = {"WorldBegin ",
                               "WorldEnd ",
                               "FrameBegin 1 ",
                               "FrameEnd ",
                               "AttributeBegin ",
                               "AttributeEnd ",
                               "TransformBegin ",
                               "TransformEnd ",
                               "ObjectBegin 1 ",
                               "ObjectEnd ",
                               "ObjectInstance 1 ",
                               "MotionBegin [0 1] ",
                               "MotionEnd ",
                               "IfBegin \"1\" ",
                               "IfBegin \"$x ==\" ",
                               "Else ",
                               "IfEnd ",
                               "ArchiveBegin \"a\" ",
                               "ArchiveEnd ",
                               "ReadArchive \"a\" ",
                               "Sphere 1 -1 1 360 ",
                               "Color [1 0 0] ",
                               "Declare \"x\" \"uniform float\" ",
                               "Surface \"s\" \"x\" 1 ",
                               "Attribute \"a\" \"x\" [1] ",
                               "Option \"user\" \"x\" 1 ",
                               "Display \"a\" \"b\" \"rgb\" ",
                               "Detail [0 1 0 1 0 1] ",
                               "DetailRange [0 0 1 1] ",
                               "Perspective 90 ",
                               "Translate 1 2 3 ",
                               "Scale 0 0 0 ",
                               "Transform [1] ",
                               "Skew 45 0 1 0 1 0 0 ",
                               "Format 4 4 1 ",
                               "[",
                               "]",
                               "\"",
                               "1e3 ",
                               "\200\1",
                               "\246\1",
                               "\314\1\"Color\"",
                               "\310\1\0\0\0\0",
                               "SolidBegin \"union\" ",
                               "SolidEnd ",
                               "Imager \"i\" ",
                               "Polygon \"P\" [0 0 0 1 0 0 0 1 0] ",
                               "DepthOfField 1 1 1 ",
                               "LightSource \"l\" 1 ",
                               "AreaLightSource \"l\" 2 ",
                               "Illuminate 1 0 ",
                               "CoordSysTransform \"world\" ",
                               "Procedural \"DelayedReadArchive\" [\"a\"] [0 1 0 1 0 1] "};
  uint32_t random = 1;
  auto next = [&](size_t count) { return size_t((random = hash(random, 7))) % count; };
  int read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = next(3) ? "WorldBegin " : "";
    for (size_t i = next(24); i > 0; --i)
      text += words[next(std::size(words))];
    if (next(4) == 0 && !text.empty())
      text[next(text.size())] = char(next(256));
    if (next(3) == 0)
      text += "WorldEnd";
    Warnings warnings(nullptr);
    warnings.keepGoing = next(2) == 0;
    try {
      readRib(fileOf(text), warnings);
      ++read;
    } catch (const UserError &) {
    }
  }
  CHECK(read > 10);
}
