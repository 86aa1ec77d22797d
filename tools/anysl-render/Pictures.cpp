//===-- tools/anysl-render/Pictures.cpp - textures, for both hosts ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Pictures.h"

#include "tools/anysl-render/Scene.h"

#include <cstdio>
#include <filesystem>

using namespace anysl::render;
namespace fs = std::filesystem;

std::unique_ptr<anysl::textures::Textures>
anysl::render::makePictures(const SceneDescription &scene) {
  textures::TextureSettings settings;
  auto add = [&](const std::string &folder) {
    fs::path path = fs::path(scene.folder) / folder;
    settings.searchPath.push_back(path.empty() ? "." : path.string());
  };
  auto option = scene.options.find("searchpath:texture");
  if (option != scene.options.end())
    for (const std::string &list : option->second.strings)
      for (size_t begin = 0; begin <= list.size();) {
        size_t end = std::min(list.find(':', begin), list.size());
        std::string folder = list.substr(begin, end - begin);
        begin = end + 1;
        // & and @ stand for what is there by default.
        if (!folder.empty() && folder != "&" && folder != "@")
          add(folder);
      }
  add("");
  settings.warn = [](const std::string &message) {
    std::fprintf(stderr, "anysl-render: warning: %s\n", message.c_str());
  };
  return textures::Textures::create(std::move(settings));
}

static anysl::textures::Textures &pictures(void *renderer) {
  return static_cast<const Shader *>(renderer)->scene->pictures();
}

void anysl::render::serveTexture(void *renderer, const AnyslShadeArgs *args, uint32_t,
                                 uint32_t width, uint32_t mask, const AnyslTextureRequest *request,
                                 const AnyslTexturePoints *points, float *result) {
  pictures(renderer).texture(args, width, mask, *request, *points, result);
}

void anysl::render::serveEnvironment(void *renderer, const AnyslShadeArgs *args, uint32_t,
                                     uint32_t width, uint32_t mask,
                                     const AnyslTextureRequest *request,
                                     const AnyslTexturePoints *points, float *result) {
  pictures(renderer).environment(args, width, mask, *request, *points, result);
}

void anysl::render::serveShadow(void *renderer, const AnyslShadeArgs *args, uint32_t,
                                uint32_t width, uint32_t mask, const AnyslTextureRequest *request,
                                const AnyslTexturePoints *points, float *result) {
  pictures(renderer).shadow(args, width, mask, *request, *points, result);
}
