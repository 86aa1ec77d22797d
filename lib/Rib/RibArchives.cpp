//===-- lib/Rib/RibArchives.cpp - requests from other files, and requests kept for later ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibReader.h"
#include "lib/Rib/RibState.h"

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

/// What an object or archive opens it has to close. Where an error ends it, this does.
class RibState::Enclosure {
public:
  explicit Enclosure(RibState &state)
      : state(state), floor(std::exchange(state.blockFloor, state.blocks.size())),
        conditions(state.conditions.size()) {}
  ~Enclosure() {
    while (state.blocks.size() > state.blockFloor) {
      Block kind = state.blocks.back().kind;
      state.blocks.pop_back();
      state.state = std::move(state.savedStates.back());
      state.savedStates.pop_back();
      if (kind == Block::World || kind == Block::Frame) {
        state.scene = std::move(state.savedScenes.back());
        state.savedScenes.pop_back();
      }
    }
    state.blockFloor = floor;
    state.recording.reset();
    state.conditions.resize(std::min(conditions, state.conditions.size()));
  }
  Enclosure(const Enclosure &) = delete;
  Enclosure &operator=(const Enclosure &) = delete;

  void check() const {
    if (state.recording)
      throw UserError(state.recording->where, state.recording->begin + " without its end");
    if (state.conditions.size() > conditions)
      throw UserError(state.conditions.back().where, "IfBegin without its end");
    if (state.blocks.size() > state.blockFloor)
      throw UserError(state.blocks.back().where,
                      "a block that is not closed in its object or archive");
  }

private:
  RibState &state;
  size_t floor, conditions;
};

void RibState::replay(const Recording &requests, const Location &where) {
  if (std::find(openReplays.begin(), openReplays.end(), requests) != openReplays.end())
    throw UserError(where, "an object or archive that holds itself");
  openReplays.push_back(requests);
  struct Pop {
    std::vector<Recording> &stack;
    ~Pop() { stack.pop_back(); }
  } pop{openReplays};
  Enclosure enclosure(*this);
  for (const RibRequest &request : *requests)
    execute(request);
  enclosure.check();
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
  struct Restore {
    GraphicsState &state, saved = state;
    ~Restore() { state = std::move(saved); }
  } restore{state};
  replay(Recording(object->second), arguments.where());
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
  struct Pop {
    std::vector<fs::path> &stack;
    ~Pop() { stack.pop_back(); }
  } pop{openArchives};
  Enclosure enclosure(*this);
  try {
    readRequests(file, *this);
    enclosure.check();
  } catch (const UserError &error) {
    throw error.withNote(where, "read from here");
  }
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
