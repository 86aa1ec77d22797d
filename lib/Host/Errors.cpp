//===-- lib/Host/Errors.cpp - versions and the last error -------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <algorithm>

static thread_local std::string lastError;
static thread_local bool outOfMemory = false;

namespace anysl::host {

AnyslStatus fail(AnyslStatus status, const std::string &message) {
  lastError = message;
  outOfMemory = false;
  return status;
}

AnyslStatus failForMemory() {
  outOfMemory = true;
  return ANYSL_ERROR_MEMORY;
}

AlignedBuffer::AlignedBuffer(size_t bytes) {
  size_t rounded = (bytes + 63) / 64 * 64;
  memory.reset(static_cast<char *>(std::aligned_alloc(64, rounded)));
  if (!memory)
    throw std::bad_alloc();
  std::fill_n(memory.get(), rounded, 0);
}

} // namespace anysl::host

extern "C" {

uint32_t anysl_abi_version(void) { return ANYSL_ABI_VERSION; }
uint32_t anysl_api_version(void) { return ANYSL_API_VERSION; }
const char *anysl_version_string(void) { return ANYSL_VERSION; }
const char *anysl_last_error(void) { return outOfMemory ? "out of memory" : lastError.c_str(); }

} // extern "C"
