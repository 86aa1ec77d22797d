/*===-- anysl/demand.h - what a shader library was linked for -----------------------------*- C
 *-*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===
 *
 * A library linked for a scene (anysl-link --scene, docs/effects.md) has only what the scene calls
 * for. It carries what that was, so that a renderer that wants more is refused, with the reason:
 * parameters that were folded take no other value (anysl_instance_set_numbers says so), and what a
 * scene may not have is asked for here:
 *
 *     AnyslSceneFacts facts = {sizeof facts};
 *     facts.has = 1u << ANYSL_ASSUMES_NO_LIGHTS;      // there are lights
 *     if (anysl_library_allows(library, &facts))      // ANYSL_ERROR_STATE, and anysl_last_error()
 *       ...                                           // use the general library instead
 *
 * anysl_library_open_for() does both. Where lights are linked in, they have to be the scene's: in
 * number, in kind, and in what else is constant of them (AnyslSceneFacts::lights).
 *
 *===--------------------------------------------------------------------------------------------===*/

#ifndef ANYSL_DEMAND_H
#define ANYSL_DEMAND_H

#include <anysl/anysl.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The bits of AnyslDemandInfo::assumes. */
typedef enum AnyslAssumption {
#define ANYSL_ASSUMPTION(id, name, doc) ANYSL_ASSUMES_##name = id,
#include <anysl/Assumptions.def>
  ANYSL_ASSUMPTION_COUNT
} AnyslAssumption;

/** The symbol of such a library's AnyslDemandInfo. */
#define ANYSL_DEMAND_SYMBOL "anysl_demand"

/** How many lights may be linked into shaders; with more, shaders go through them in a loop. */
#define ANYSL_MOST_LINKED_LIGHTS 8

/** The bits of AnyslLinkedLight::known. */
enum {
  ANYSL_KNOWN_COLOR = 1,
  ANYSL_KNOWN_FROM = 2,
  ANYSL_KNOWN_DIRECTION = 4,
  ANYSL_KNOWN_CONE = 8, /**< cos_outer and cos_inner */
  ANYSL_KNOWN_BEAM = 16,
  ANYSL_KNOWN_CATEGORY = 32,
  ANYSL_KNOWN_CODE = 64 /**< of a light shader, which then runs within the surface */
};

/** A light that is linked into shaders: its kind, and of its other values those that are known. */
typedef struct AnyslLinkedLight {
  AnyslLight light;
  uint32_t known;       /**< bits ANYSL_KNOWN_...; the others are those of the batch's light */
  uint32_t known_flags; /**< the flags that are known */
} AnyslLinkedLight;

/** A value of a linked light shader's parameter that is a constant in the code. */
typedef struct AnyslLinkedParam {
  uint32_t light;   /**< its number in the batch */
  uint32_t cell;    /**< in AnyslLight::params */
  const char *name; /**< of the parameter */
  const char *text; /**< null: it is a number */
  double number;
} AnyslLinkedParam;

/** What a shader's source has, of which its scene may not call for all. A host that treats shaders
    by what they can do, such as lights that look for shadows themselves, goes by this. */
typedef struct AnyslSourceInfo {
  uint64_t globals_written; /**< as in AnyslShaderInfo */
  uint32_t effects;
  uint32_t keeps_opacity; /**< of the shader as it was linked, not of its source: 1 if it leaves Oi
                               as it is, or makes it Os; 0: not known */
} AnyslSourceInfo;

/** A global that is the same at all points of a scene. */
typedef struct AnyslFixedGlobal {
  uint32_t global; /**< ANYSL_Os ... */
  uint32_t reserved;
  double value[3];
} AnyslFixedGlobal;

typedef struct AnyslDemandInfo {
  uint32_t struct_size;
  uint32_t assumes;               /**< bit 1 << ANYSL_ASSUMES_...: what the scene does without */
  uint64_t digest;                /**< of the manifest: equal for equal demands */
  const char *manifest;           /**< what it was linked for, as JSON (docs/effects.md) */
  const char *dropped_outputs;    /**< names of the outputs nobody looks at, with commas: output
                                       parameters, and "Ci" or "Oi" of surfaces */
  double time;                    /**< of all points, where no motion is assumed */
  const AnyslSourceInfo *sources; /**< of each shader of the library */
  const AnyslLinkedLight *lights; /**< those that shine on all points, in the batch's order; null:
                                       any may */
  uint32_t light_count;
  uint32_t ambient_known; /**< 1: ambient lights add up to `ambient` in every batch */
  float ambient[3];
  uint32_t fixed_global_count;
  const AnyslFixedGlobal *fixed_globals;
  const AnyslLinkedParam *linked_params;
  uint32_t linked_param_count;
  uint32_t reserved;
} AnyslDemandInfo;

/** What a renderer's scene has, and wants to see. */
typedef struct AnyslSceneFacts {
  uint32_t struct_size;
  uint32_t has; /**< bit 1 << ANYSL_ASSUMES_...: it has what is assumed not to be there */
  const char *const *outputs; /**< output parameters that it wants, with a null pointer behind the
                                   last; null: none. Ci and Oi are wanted as well, unless the list
                                   names one of the two and not the other */
  double time;                /**< of all points, where it has no motion */
  const AnyslLight *lights;   /**< that shine on all points; asked for where lights are linked in */
  uint32_t light_count;
  float ambient[3]; /**< what ambient lights add up to; likewise */
} AnyslSceneFacts;

/** What a library was linked for; null of one that serves every scene. Lives as long as the
 * library. */
ANYSL_API const AnyslDemandInfo *anysl_library_demand(const AnyslLibrary *library);

/** What one of a library's shaders could do for any scene. */
ANYSL_API AnyslSourceInfo anysl_library_source(const AnyslLibrary *library,
                                               const AnyslShaderInfo *shader);

/** ANYSL_OK if a library has all that a scene calls for, else ANYSL_ERROR_STATE. */
ANYSL_API AnyslStatus anysl_library_allows(const AnyslLibrary *library,
                                           const AnyslSceneFacts *facts);

/**
 * Opens a library linked for a scene if it has all that this one calls for, else the general one.
 * A null `general` leaves it at the refusal. Which one it is, anysl_library_demand() tells.
 */
ANYSL_API AnyslStatus anysl_library_open_for(const char *path, const char *general,
                                             const AnyslSceneFacts *facts, AnyslLibrary **library);

#ifdef __cplusplus
}
#endif

#endif
