//===-- test/hard-cases/HardCases.cpp - runs the table of hard cases --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   hard-cases [--markdown] LIBRARY.so…
//
// The libraries hold the shaders of Rows.def. Every row is run in each that has its shader; a row
// that none has is an error. Libraries after the first have to give the bits of the first that
// computes in the same format with the same math tier, whatever their layout, instruction set or
// real.
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Page.h"
#include "test/hard-cases/Run.h"
#include <cstdio>
#include <cstring>
#include <set>
#include <stdexcept>
#include <xmmintrin.h>

using namespace hardcases;

namespace {

int failures = 0;

void report(const std::string &text) {
  ++failures;
  std::fprintf(stderr, "hard-cases: %s\n", text.c_str());
}

void checkBound(const Row &row, const Measured &m, const std::string &where) {
  if (m.beyond == 0)
    return;
  char text[256];
  std::snprintf(text, sizeof text,
                "row %d, %s: %zu of %zu beyond %s, %zu wrong, worst %.3Lg; first for", row.number,
                row.shader, m.beyond, m.count, row.bound.text().c_str(), m.wrong, m.worst);
  report(where + text + describe(m.first));
}

struct Library {
  explicit Library(const std::string &path) : path(path) {
    unsigned before = _mm_getcsr() & ~0x3fu;
    if (anysl_library_open(path.c_str(), 0, &library) != ANYSL_OK)
      throw std::runtime_error(anysl_last_error());
    if ((_mm_getcsr() & ~0x3fu) != before)
      report(path + ": loading it has changed the floating-point environment");
  }
  ~Library() { anysl_library_close(library); }

  const AnyslShaderInfo *find(const char *shader) const {
    const AnyslLibraryInfo *info = anysl_library_info(library);
    for (uint32_t i = 0; i < info->shader_count; ++i)
      if (("hard_" + std::string(shader)) == info->shaders[i].name)
        return &info->shaders[i];
    return nullptr;
  }

  std::string path;
  AnyslLibrary *library = nullptr;
};

void runLibrary(const std::string &path, std::map<std::string, Results> &results, Page &page,
                std::set<const Row *> &done) {
  Library library(path);
  const AnyslLibraryInfo *info = anysl_library_info(library.library);
  std::string kind =
      std::string(info->real == ANYSL_REAL_DOUBLE ? "double " : "float ") + info->math;
  for (const Row &row : rows()) {
    if (!row.shader || row.kernel)
      continue;
    const AnyslShaderInfo *shader = library.find(row.shader);
    if (!shader)
      continue;
    std::vector<uint32_t> widths;
    for (uint32_t i = 0; i < shader->entry_count; ++i)
      widths.push_back(shader->entries[i].width);
    Subject subject(library.library, shader->name);
    Complaints complaints;
    Measured measured = runRow(row, subject, widths, results[kind], complaints);
    for (const std::string &complaint : complaints)
      report(path + ": " + complaint);
    checkBound(row, measured, path + ": ");
    page.note(row, measured);
    done.insert(&row);
  }
}

} // namespace

int main(int argc, char **argv) {
  bool markdown = false, partial = false;
  std::vector<std::string> libraries;
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--markdown") == 0)
      markdown = true;
    else if (std::strcmp(argv[i], "--partial") == 0)
      partial = true;
    else
      libraries.push_back(argv[i]);

  Page page;
  std::set<const Row *> done;
  std::map<std::string, Results> results;
  try {
    for (const std::string &path : libraries)
      runLibrary(path, results, page, done);
    for (const Row &row : rows())
      if (row.kernel && !partial) {
        Measured measured = runKernel(row);
        checkBound(row, measured, "");
        page.note(row, measured);
      } else if (row.shader && !row.kernel && !partial && !done.count(&row)) {
        report(std::string("no library has the shader of row ") + std::to_string(row.number) +
               ", hard_" + row.shader);
      }
  } catch (const std::exception &error) {
    report(error.what());
  }
  if (markdown && failures == 0)
    page.print();
  if (failures > 0)
    return 1;
  if (!markdown)
    std::printf("every row holds in %zu libraries\n", libraries.size());
  return 0;
}
