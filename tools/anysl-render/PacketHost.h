//===-- tools/anysl-render/PacketHost.h - packets of rays for their services ------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_PACKETHOST_H
#define ANYSL_RENDER_PACKETHOST_H

#include "tools/anysl-render/Queries.h"
#include "tools/anysl-render/RayList.h"

namespace anysl::render {

/// Rays that met surfaces whose points share a batch.
struct Members {
  const RayList &rays;
  const uint32_t *numbers; ///< of the rays
  uint32_t count;
  const ShadingGroup &group;
  const Shader *volume; ///< that they came through, or null
  RayPath path;
  float *channels; ///< of all targets, or null
};

/// What AnyslShadeArgs::batch points to.
struct PacketBatch {
  const class PacketHost *host;
  ThreadState *state;
  const ShadingGroup *group;
  const RayStarts *starts;
  const uint32_t *seeds;
  uint32_t *rays; ///< how many rays each point has traced so far
  RayPath path;
  const Shader *volume; ///< that the rays came through, or null
  const Members *members;
  const AnyslShadeArgs *surface = nullptr; ///< while a volume is shaded, what the surface was with

  /// What is known of a point, which may lie beyond the last one.
  Asker asker(uint32_t point) const {
    Asker result{group, volume, surface, path, {}};
    if (point < members->count)
      result.hit = members->rays.hitOf(members->numbers[point]);
    return result;
  }
};

/// How the services see the host, whatever the width of its packets.
class PacketHost : public Host {
public:
  virtual void follow(ThreadState &state, RayList &rays, const RayPurpose &purpose,
                      Radiance *radiance, float *channels,
                      AnyslMessage *values = nullptr) const = 0;
  virtual void nearest(RayList &rays, const RayPurpose &purpose) const = 0;
  /// How much light arrives along the rays, which a batch's points ask for. Where a shader is asked
  /// how opaque a surface is, those behind that shader's own shadow rays are as they are anyhow.
  virtual void transmission(const PacketBatch &from, RayList &rays, RayPurpose purpose,
                            Vec3f *passing) const = 0;
};

extern const AnyslServices packetServices;

} // namespace anysl::render

#endif
