//===-- lib/Shade/Handles.cpp - the loader's objects, owned -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Handles.h"
#include <new>

namespace anysl::shade {

void check(AnyslStatus status) {
  if (status == ANYSL_ERROR_MEMORY)
    throw std::bad_alloc();
  if (status)
    throw UserError(anysl_last_error());
}

void printNotes(AnyslNoteLog *notes, std::FILE *file) {
  uint64_t count;
  for (size_t i = 0; notes; ++i) {
    const char *text = anysl_note_log_entry(notes, i, &count);
    if (!text)
      break;
    std::fprintf(file, "%s", text);
    if (count > 1)
      std::fprintf(file, ", and %llu more", static_cast<unsigned long long>(count - 1));
    std::fputc('\n', file);
  }
}

LibraryHandle openLibrary(const std::string &path) {
  AnyslLibrary *opened = nullptr;
  check(anysl_library_open(path.c_str(), 0, &opened));
  return LibraryHandle(opened);
}

InstanceHandle makeInstance(AnyslLibrary *library, const std::string *shader,
                            const AnyslServices &services, Environment &environment) {
  AnyslInstance *created = nullptr;
  check(anysl_instance_create(library, shader ? shader->c_str() : nullptr, &services, &environment,
                              &created));
  return InstanceHandle(created);
}

void setParam(AnyslInstance *instance, ParamText param, const std::string &option, bool asFloats) {
  // As anysl-link takes it: SHADER.NAME=VALUE.
  const AnyslShaderInfo &shader = *anysl_instance_shader(instance);
  std::string prefix = std::string(shader.name) + ".";
  if (param.name.compare(0, prefix.size(), prefix) == 0)
    param.name.erase(0, prefix.size());
  const AnyslParamInfo *info = anysl_shader_param(&shader, param.name.c_str());
  if (!info || info->type != ANYSL_STRING) {
    // An unknown name is best reported by the library, whatever the value.
    std::vector<double> numbers =
        info ? parseNumbers(param.value, option + " " + param.name) : std::vector<double>(1);
    for (double &number : numbers)
      number = asFloats ? double(float(number)) : number;
    return check(
        anysl_instance_set_numbers(instance, param.name.c_str(), numbers.data(), numbers.size()));
  }
  std::vector<std::string> texts = {param.value};
  if (info->array_length)
    texts = split(param.value, ',');
  std::vector<const char *> pointers;
  for (const std::string &text : texts)
    pointers.push_back(text.c_str());
  check(anysl_instance_set_strings(instance, param.name.c_str(), pointers.data(), pointers.size()));
}

} // namespace anysl::shade
