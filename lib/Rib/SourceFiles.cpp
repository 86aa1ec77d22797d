//===-- lib/Rib/SourceFiles.cpp - files as texts, packed or not -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibReader.h"

#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace anysl::render;

namespace {

/// What a file that `gzip` has written stands for: all of its members, one after the other.
std::string unpack(const std::string &packed, const std::string &name) {
  z_stream stream = {};
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK)
    throw std::bad_alloc();
  struct End {
    z_stream &stream;
    ~End() { inflateEnd(&stream); }
  } end{stream};
  std::string text;
  size_t taken = 0;
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(packed.data()));
  for (;;) {
    char buffer[1 << 16];
    stream.avail_in = uInt(std::min(packed.size() - taken, size_t(1) << 30));
    stream.next_out = reinterpret_cast<Bytef *>(buffer);
    stream.avail_out = sizeof buffer;
    uInt before = stream.avail_in;
    int status = inflate(&stream, Z_NO_FLUSH);
    taken += before - stream.avail_in;
    text.append(buffer, sizeof buffer - stream.avail_out);
    if (status == Z_STREAM_END) {
      if (taken + 2 > packed.size() || packed.compare(taken, 2, "\x1f\x8b") != 0)
        return text; // what follows is padding
      inflateReset(&stream);
    } else if (status == Z_BUF_ERROR ||
               (status == Z_OK && taken == packed.size() && stream.avail_out == sizeof buffer)) {
      throw UserError("cannot read '" + name + "': its packed data end too early");
    } else if (status != Z_OK) {
      throw UserError("cannot read '" + name + "': its packed data are damaged" +
                      (stream.msg ? std::string(" (") + stream.msg + ")" : ""));
    }
  }
}

} // namespace

std::shared_ptr<const SourceFile> anysl::render::loadSourceFile(const std::string &path) {
  std::error_code error;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path, error))
    throw UserError("cannot read '" + path + "'");
  auto file = std::make_shared<SourceFile>();
  file->name = path;
  file->text.assign(std::istreambuf_iterator<char>(stream), {});
  if (file->text.starts_with("\x1f\x8b"))
    file->text = unpack(file->text, path);
  return file;
}
