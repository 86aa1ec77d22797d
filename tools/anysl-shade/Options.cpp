//===-- tools/anysl-shade/Options.cpp - the command line --------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-shade/Options.h"
#include <algorithm>
#include <cstdio>
#include <cstring>

namespace anysl::shade {
namespace {

constexpr const char *usage =
    R"(usage: anysl-shade FILE.so [options]

Shades a grid of points without a renderer. )";

constexpr const char *ownHelp =
    R"(
What to do with it:
  --print NAME             print a global or an output parameter (repeatable);
                           default: every global that the shader writes
  --json                   print {"width":W,"height":H,"NAME":[...],...}, one entry a point,
                           row by row; a number, or an array of its components; what the
                           shader itself prints goes to the standard error output
  -o IMAGE                 write Ci as an image (.png, .exr, ...), row j = 0 on top; 8 and
                           16 bit images get the values as they are, without a gamma
  --bench                  time the shader at each width

)";

constexpr const char *whatHelp =
    R"(
What to shade:
  --shader NAME            the shader, if the library has several
  --grid WxH               default: 4x4; with -o 256x256, with --bench 64x64
  --width N                points at once; default: the library's widest
)";

[[noreturn]] void fail(const std::string &message) { throw UserError(message); }

struct Option {
  const char *name;
  void (*read)(Options &, const std::string &);
};

constexpr Option table[] = {
    {"--shader", [](Options &o, const std::string &v) { o.shader = v; }},
    {"--width", [](Options &o, const std::string &v) { o.width = parseCount(v, "--width"); }},
    {"--print", [](Options &o, const std::string &v) { o.print.push_back(v); }},
    {"-o", [](Options &o, const std::string &v) { o.image = v; }},
};

bool Options::*flagNamed(const std::string &name) {
  return name == "--json" ? &Options::json : name == "--bench" ? &Options::bench : nullptr;
}

/// Reads the option at \p arg and returns the last argument that belongs to it.
int parseOption(Options &options, int arg, int argc, char **argv) {
  std::string name = argv[arg];
  // --name=value, but not for the short -o.
  size_t equals = name.compare(0, 2, "--") == 0 ? name.find('=') : std::string::npos;
  std::string key = name.substr(0, equals);
  if (bool Options::*flag = flagNamed(key)) {
    if (equals != std::string::npos)
      fail(key + " takes no value");
    options.*flag = true;
    return arg;
  }
  bool apart = equals == std::string::npos;
  auto read = [&](const auto &known) {
    auto found = std::find_if(std::begin(known), std::end(known),
                              [&](const auto &option) { return key == option.name; });
    if (found == std::end(known))
      return false;
    if (apart && arg + 1 == argc)
      fail(name + " wants a value");
    found->read(options, apart ? argv[arg + 1] : name.substr(equals + 1));
    return true;
  };
  if (!read(table) && !read(gridOptions()))
    fail("unknown option '" + key + "'; --help lists them all");
  return arg + apart;
}

} // namespace

std::optional<Options> parseOptions(int argc, char **argv) {
  Options options;
  for (int arg = 1; arg < argc; ++arg) {
    if (!std::strcmp(argv[arg], "--help") || !std::strcmp(argv[arg], "-h")) {
      for (const char *part : {usage, gridHelp, whatHelp, pointsHelp, ownHelp, worldHelp})
        std::fputs(part, stdout);
      return std::nullopt;
    }
    if (!std::strcmp(argv[arg], "--version")) {
      std::puts("anysl-shade " ANYSL_VERSION);
      return std::nullopt;
    }
    if (argv[arg][0] == '-' && argv[arg][1])
      arg = parseOption(options, arg, argc, argv);
    else if (!options.library.empty())
      fail("one shader library at a time: '" + options.library + "' and '" + argv[arg] + "'");
    else
      options.library = argv[arg];
  }
  if (options.json)
    options.environment.printTo = stderr;
  if (options.library.empty())
    fail("no shader library given; --help explains");
  if (!options.gridWidth)
    options.gridWidth = options.gridHeight = !options.image.empty() ? 256 : options.bench ? 64 : 4;
  options.needsColor = !options.image.empty();
  return options;
}

} // namespace anysl::shade
