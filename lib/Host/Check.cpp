//===-- lib/Host/Check.cpp - whether a library's descriptor can be relied upon ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Every later call trusts the descriptor, so what could lead it astray is refused here, with a
// sentence that says what to do about it.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"

using namespace anysl::host;

namespace {

std::string quantities(const char *what, uint32_t found, uint32_t expected) {
  return std::string(what) + " is " + std::to_string(found) + ", this program's is " +
         std::to_string(expected);
}

AnyslStatus checkVersion(const LoadedLibrary &library) {
  const AnyslLibraryInfo &info = *library.info;
  if (info.magic != ANYSL_MAGIC)
    return fail(ANYSL_ERROR_NOT_A_LIBRARY,
                library.path + ": not a shader library: its descriptor has the wrong magic number");
  if (info.abi_version != ANYSL_ABI_VERSION)
    return fail(ANYSL_ERROR_VERSION, library.path + ": " +
                                         quantities("the version of its binary interface",
                                                    info.abi_version, ANYSL_ABI_VERSION) +
                                         "; link the shaders again with this program's anysl-link");
  std::string odd;
  if (info.struct_size != sizeof(AnyslLibraryInfo))
    odd = quantities("its descriptor's size", info.struct_size, sizeof(AnyslLibraryInfo));
  else if (info.shade_args_size != sizeof(AnyslShadeArgs))
    odd = quantities("its size of AnyslShadeArgs", info.shade_args_size, sizeof(AnyslShadeArgs));
  else if (info.services_size != sizeof(AnyslServices))
    odd = quantities("its size of AnyslServices", info.services_size, sizeof(AnyslServices));
  else if (info.global_count > ANYSL_GLOBAL_COUNT)
    odd = quantities("its number of shader globals", info.global_count, ANYSL_GLOBAL_COUNT);
  else if (info.layout == ANYSL_LAYOUT_AOS && info.component_count != ANYSL_COMPONENT_COUNT)
    // The number of components is the distance from point to point.
    odd = quantities("its number of components of a point", info.component_count,
                     ANYSL_COMPONENT_COUNT);
  if (!odd.empty())
    return fail(ANYSL_ERROR_VERSION, library.path + ": " + odd +
                                         "; link the shaders again with this program's anysl-link");
  return ANYSL_OK;
}

AnyslStatus damaged(const LoadedLibrary &library, const std::string &what) {
  return fail(ANYSL_ERROR_NOT_A_LIBRARY, library.path + ": damaged shader library: " + what);
}

AnyslStatus checkParam(const LoadedLibrary &library, const AnyslShaderInfo &shader,
                       const AnyslParamInfo &param) {
  if (!param.name || !anysl_type_components(param.type))
    return damaged(library,
                   std::string("shader '") + shader.name + "' has a parameter without a type");
  uint64_t elements = param.array_length ? param.array_length : 1;
  uint64_t end = param.first_cell + elements * anysl_type_components(param.type);
  if (end > shader.cell_count)
    return damaged(library, std::string("parameter '") + param.name + "' of shader '" +
                                shader.name + "' lies outside the shader's cells");
  return ANYSL_OK;
}

AnyslStatus checkShader(const LoadedLibrary &library, const AnyslShaderInfo &shader) {
  if (!shader.name || (shader.param_count && !shader.params) ||
      (shader.entry_count && !shader.entries))
    return damaged(library, "a shader's tables are missing");
  if (!shader.entry_count)
    return damaged(library, std::string("shader '") + shader.name + "' has no code");
  for (uint32_t i = 0; i < shader.entry_count; ++i)
    if (!shader.entries[i].width || !shader.entries[i].shade)
      return damaged(library, std::string("shader '") + shader.name + "' has no code");
  if ((shader.globals_read | shader.globals_written) >> library.info->global_count)
    return damaged(library, std::string("shader '") + shader.name + "' uses unknown globals");
  for (uint32_t i = 0; i < shader.param_count; ++i)
    if (AnyslStatus status = checkParam(library, shader, shader.params[i]))
      return status;
  return ANYSL_OK;
}

AnyslStatus checkTables(const LoadedLibrary &library) {
  const AnyslLibraryInfo &info = *library.info;
  if (info.layout != ANYSL_LAYOUT_SOA && info.layout != ANYSL_LAYOUT_AOS)
    return damaged(library,
                   "its data layout has the unknown number " + std::to_string(info.layout));
  if (info.real != ANYSL_REAL_FLOAT && info.real != ANYSL_REAL_DOUBLE)
    return damaged(library,
                   "its number format has the unknown number " + std::to_string(info.real));
  if (info.shader_count && !info.shaders)
    return damaged(library, "its list of shaders is missing");
  for (uint32_t i = 0; i < info.shader_count; ++i)
    if (AnyslStatus status = checkShader(library, info.shaders[i]))
      return status;
  return ANYSL_OK;
}

AnyslStatus checkProcessor(const LoadedLibrary &library) {
  const AnyslLibraryInfo &info = *library.info;
  std::string missing = missingCpuFeatures(info.cpu_features);
  if (missing.empty() || library.inspectOnly)
    return ANYSL_OK;
  std::string cpu = info.target_cpu ? info.target_cpu : "another processor";
  return fail(ANYSL_ERROR_CPU, library.path + ": compiled for " + cpu + ", whose " + missing +
                                   " this processor lacks; link the shaders with a smaller --mcpu");
}

} // namespace

AnyslStatus anysl::host::checkDescriptor(const LoadedLibrary &library) {
  if (AnyslStatus status = checkVersion(library))
    return status;
  if (AnyslStatus status = checkTables(library))
    return status;
  return checkProcessor(library);
}
