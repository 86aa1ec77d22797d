//===-- lib/Rib/FileTypes.cpp - types of displays that are files ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/FileTypes.h"

#include <map>

const char *anysl::render::fileFormat(std::string_view displayType) {
  static const std::map<std::string_view, const char *> formats = {
      {"file", ""},       {"tiff", "tiff"}, {"tif", "tiff"},    {"zfile", "tiff"},
      {"shadow", "tiff"}, {"png", "png"},   {"exr", "openexr"}, {"openexr", "openexr"},
      {"jpeg", "jpeg"},   {"jpg", "jpeg"},  {"targa", "targa"}, {"tga", "targa"},
      {"sgi", "sgi"},     {"bmp", "bmp"},   {"ppm", "pnm"},     {"rgbe", "hdr"},
      {"hdr", "hdr"},     {"null", ""}};
  auto found = formats.find(displayType);
  return found == formats.end() ? nullptr : found->second;
}
