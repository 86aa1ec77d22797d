//===-- tools/anysl-render/HostServices.h - services that all hosts give alike ----*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A host's `Batch` is what AnyslShadeArgs::batch points to; it has the ThreadState `state`, the
// ShadingGroup `group`, and asker(point), which tells of one of its points. There is no batch while
// parameters' defaults are computed.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_HOSTSERVICES_H
#define ANYSL_RENDER_HOSTSERVICES_H

#include "tools/anysl-render/Host.h"
#include "tools/anysl-render/Pictures.h"
#include "tools/anysl-render/Queries.h"

#include <optional>

namespace anysl::render {

template <typename Batch>
struct BatchServices {
  static Asker askerOf(const AnyslShadeArgs *args, uint32_t point) {
    const auto *batch = static_cast<const Batch *>(args->batch);
    return batch ? batch->asker(point) : Asker();
  }

  /// A lookup in a picture, while the clock of shading stands.
  template <AnyslTextureService *service>
  static void outsideShading(void *renderer, const AnyslShadeArgs *args, uint32_t first,
                             uint32_t width, uint32_t mask, const AnyslTextureRequest *request,
                             const AnyslTexturePoints *points, float *result) {
    std::optional<ServiceScope> scope;
    if (args->batch)
      scope.emplace(*static_cast<Batch *>(args->batch)->state);
    service(renderer, args, first, width, mask, request, points, result);
  }
  static int serveMatrix(void *renderer, const AnyslShadeArgs *args, const char *from,
                         const char *to, double *matrix) {
    const auto *batch = static_cast<const Batch *>(args->batch);
    return serveSpaceMatrix(renderer, batch ? &batch->group->object : nullptr, from, to, matrix);
  }
  static int serveNamed(void *renderer, const AnyslShadeArgs *args, uint32_t point,
                        const AnyslQuery *query, AnyslCell *value) {
    return serveQuery(*static_cast<const Shader *>(renderer), askerOf(args, point), args, point,
                      *query, value);
  }
  static int serveCall(void *renderer, const AnyslShadeArgs *args, uint32_t point,
                       const char *handle, AnyslMessage *message) {
    return serveMethod(*static_cast<const Shader *>(renderer), askerOf(args, point), args, point,
                       handle, *message);
  }
  static const char *serveName(void *renderer, const AnyslShadeArgs *args, const char *category,
                               uint32_t index) {
    return serveShaderName(*static_cast<const Shader *>(renderer), askerOf(args, 0), category,
                           index);
  }
};

/// The table of services without those that follow rays.
template <typename Batch>
AnyslServices servicesOfBatch() {
  using Services = BatchServices<Batch>;
  AnyslServices offered = {};
  offered.struct_size = sizeof offered;
  offered.space_matrix = Services::serveMatrix;
  offered.texture = Services::template outsideShading<serveTexture>;
  offered.environment = Services::template outsideShading<serveEnvironment>;
  offered.shadow = Services::template outsideShading<serveShadow>;
  offered.query = Services::serveNamed;
  offered.call_method = Services::serveCall;
  offered.shader_name = Services::serveName;
  return offered;
}

} // namespace anysl::render

#endif
