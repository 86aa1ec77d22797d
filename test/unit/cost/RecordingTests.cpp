//===-- test/unit/cost/RecordingTests.cpp - recorded points and their file
//---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Options.h"
#include "lib/Shade/Recording.h"
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <unistd.h>

using namespace anysl::shade;

namespace {

struct TemporaryFile {
  std::string path = "/tmp/anysl-recording-" + std::to_string(getpid());
  ~TemporaryFile() { std::remove(path.c_str()); }
};

RecordedShader sample() {
  RecordedShader shader;
  shader.kind = "surface";
  shader.name = "wood";
  shader.file = "/a \"quoted\" \\ path\nwith a line";
  shader.points = 2;
  shader.params = {{"Kd", {0.1}, {}}, {"maps", {}, {"a b", ""}}};
  shader.spaces["world"] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 1.0 / 3};
  shader.ambient[1] = 0.25f;
  RecordedShader::Light light;
  light.values.kind = ANYSL_LIGHT_SPOT;
  light.values.flags = ANYSL_LIGHT_CASTS_SHADOW;
  light.values.from[2] = 0.1f;
  light.values.beam = 7;
  light.category = "key light";
  shader.lights = {light};
  shader.lostLights = 1;
  shader.globals = {{"P", 3, {1, 2, 3, 4, 5, 6}}, {"s", 1, {-0.0f, 1e-40f}}};
  shader.varying = {{"Cv", 3, {9, 8, 7, 6, 5, 4}}};
  shader.byU = {{"Cv", 3, {1, 0, -1, 0.5f, 3, 2}}};
  shader.byV = {{"Cv", 3, {2, 0, -2, 0.25f, 6, 4}}};
  shader.seeds = {7, 0xffffffffu};
  return shader;
}

std::string contents(const std::string &path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

} // namespace

TEST_CASE("What was recorded reads back as it was", "[recording]") {
  TemporaryFile file, again;
  again.path += "-again";
  writeRecording(file.path, {sample(), sample()});
  std::vector<RecordedShader> read = readRecording(file.path);
  REQUIRE(read.size() == 2);
  const RecordedShader &shader = read[1], expected = sample();
  CHECK(shader.file == expected.file);
  CHECK(shader.params[0].numbers == expected.params[0].numbers);
  CHECK(shader.params[1].texts == expected.params[1].texts);
  CHECK(shader.spaces == expected.spaces);
  CHECK(shader.lights[0].values.from[2] == 0.1f);
  CHECK(shader.lights[0].category == "key light");
  CHECK(shader.globals[1].numbers == expected.globals[1].numbers);
  CHECK(shader.varying[0].numbers == expected.varying[0].numbers);
  CHECK(shader.seeds == expected.seeds);
  writeRecording(again.path, read);
  CHECK(contents(again.path) == contents(file.path));
}

TEST_CASE("A damaged recording is refused wherever it ends", "[recording]") {
  TemporaryFile file;
  writeRecording(file.path, {sample()});
  std::string whole = contents(file.path);
  for (size_t length = 0; length < whole.size(); ++length) {
    // A file without any shader is whole.
    if (whole.compare(0, length, "anysl-points 1\n") == 0 ||
        whole.compare(0, length, "anysl-points 1") == 0)
      continue;
    std::ofstream(file.path, std::ios::binary) << whole.substr(0, length);
    CHECK_THROWS_AS(readRecording(file.path), UserError);
  }
}
