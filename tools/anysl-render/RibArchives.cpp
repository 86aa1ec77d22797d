//===-- tools/anysl-render/RibArchives.cpp - requests from other files, and requests kept for later
//===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RibReader.h"
#include "tools/anysl-render/RibState.h"

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;
using namespace anysl::render;

//===-- Recordings ----------------------------------------------------------//

void RibState::startRecording(const char *begin, const char *end, std::string handle,
                              const RibArguments &arguments) {
  recording.emplace();
  recording->begin = begin;
  recording->end = end;
  recording->handle = std::move(handle);
  recording->where = arguments.where();
}

void RibState::record(const RibRequest &request) {
  recording->depth += request.name == recording->begin;
  recording->depth -= request.name == recording->end;
  if (recording->depth > 0) {
    recording->requests->push_back(request);
    return;
  }
  OpenRecording done = std::move(*recording);
  recording.reset();
  if (done.begin == "ObjectBegin")
    objects.insert_or_assign(done.handle, done.requests);
  else if (done.begin == "ArchiveBegin")
    archives.insert_or_assign(done.handle, done.requests);
  else
    doMotion(done);
}

void RibState::replay(const Recording &requests, const Location &where) {
  constexpr unsigned deepest = 64;
  if (replays >= deepest)
    throw UserError(where, "objects and archives lie in each other without an end");
  size_t floor = std::exchange(blockFloor, blocks.size());
  ++replays;
  for (const RibRequest &request : *requests)
    execute(request);
  --replays;
  if (blocks.size() > blockFloor)
    throw UserError(blocks.back().where, "a block that is not closed in its object or archive");
  blockFloor = floor;
}

//===-- Objects -------------------------------------------------------------//

void RibState::objectBegin(RibArguments &arguments) {
  startRecording("ObjectBegin", "ObjectEnd", arguments.handle("a handle"), arguments);
  arguments.parameters();
}

void RibState::objectEnd(RibArguments &arguments) {
  throw UserError(arguments.where(), "ObjectEnd without ObjectBegin");
}

void RibState::objectInstance(RibArguments &arguments) {
  std::string handle = arguments.handle("an object's handle");
  arguments.parameters();
  auto object = objects.find(handle);
  if (object == objects.end())
    throw UserError(arguments.where(), "ObjectInstance: there is no object " + handle);
  GraphicsState saved = state;
  replay(Recording(object->second), arguments.where());
  state = std::move(saved);
}

//===-- Archives ------------------------------------------------------------//

void RibState::archiveBegin(RibArguments &arguments) {
  startRecording("ArchiveBegin", "ArchiveEnd", arguments.handle("a name"), arguments);
  arguments.parameters();
}

void RibState::archiveEnd(RibArguments &arguments) {
  throw UserError(arguments.where(), "ArchiveEnd without ArchiveBegin");
}

void RibState::readArchive(RibArguments &arguments) {
  std::string name = arguments.handle("a file's name");
  arguments.parameters();
  includeArchive(name, arguments.where());
}

fs::path RibState::findArchive(const std::string &name, const Location &where) const {
  std::error_code error;
  std::vector<fs::path> folders;
  fs::path sceneFolder = sceneFile.parent_path();
  auto addStandard = [&] {
    folders.push_back(openArchives.back().parent_path());
    folders.push_back(sceneFolder);
    folders.emplace_back();
  };
  if (const Parameter *path = findSetting("searchpath:archive"); path && !path->strings.empty()) {
    const std::string &list = path->strings[0];
    for (size_t begin = 0; begin <= list.size();) {
      size_t end = std::min(list.find(':', begin), list.size());
      std::string folder = list.substr(begin, end - begin);
      begin = end + 1;
      if (folder == "&" || folder == "@")
        addStandard();
      else if (!folder.empty())
        folders.push_back(sceneFolder / folder);
    }
  }
  addStandard();
  for (const fs::path &folder : folders)
    for (const char *suffix : {"", ".gz"})
      if (fs::path path = folder / (name + suffix); fs::is_regular_file(path, error))
        return path.lexically_normal();
  std::string searched;
  for (const fs::path &folder : folders)
    searched += (searched.empty() ? "" : ":") + (folder.empty() ? "." : folder.string());
  throw UserError(where, "archive \"" + name + "\" is not found in " + searched);
}

void RibState::includeArchive(const std::string &name, const Location &where) {
  if (auto archive = archives.find(name); archive != archives.end()) {
    replay(Recording(archive->second), where);
    return;
  }
  fs::path path = findArchive(name, where);
  std::error_code error;
  if (std::any_of(openArchives.begin(), openArchives.end(),
                  [&](const fs::path &open) { return fs::equivalent(open, path, error); }))
    throw UserError(where, "archive \"" + path.string() + "\" reads itself");
  std::shared_ptr<const SourceFile> file;
  try {
    file = loadSourceFile(path.string());
  } catch (const UserError &error) {
    throw UserError(where, error.message);
  }
  scene.archives.push_back(path.string());
  openArchives.push_back(path);
  size_t floor = std::exchange(blockFloor, blocks.size());
  try {
    readRequests(file, *this);
  } catch (const UserError &error) {
    throw error.withNote(where, "read from here");
  }
  openArchives.pop_back();
  if (blocks.size() > blockFloor)
    throw UserError(blocks.back().where, "a block that is not closed in its archive")
        .withNote(where, "read from here");
  blockFloor = floor;
}

void RibState::procedural(RibArguments &arguments) {
  std::string kind = arguments.string("a kind of procedure");
  const RibArgument &data = arguments.any("its arguments");
  arguments.numbers(6, "a bound");
  arguments.parameters();
  if (kind != "DelayedReadArchive" || data.strings.empty()) {
    warnings.warnOnce("procedural " + kind, arguments.where(),
                      "Procedural \"" + kind + "\" is not supported; its shapes are left out");
    return;
  }
  open(Block::Attribute, arguments);
  includeArchive(data.strings[0], arguments.where());
  close(Block::Attribute, "Attribute", arguments);
}
