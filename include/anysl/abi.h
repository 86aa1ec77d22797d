/*===-- anysl/abi.h - what a compiled shader library and a renderer agree on -------------*- C
 *-*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===
 *
 * The binary interface between three programs that never see each other's sources: the shader
 *library (written by anysl-link), the runtime inside it (compiled by clang from runtimes/), and the
 *renderer. Plain C99 data, no functions. A renderer normally includes <anysl/anysl.h>, whose loader
 *checks all of this; a runtime includes it through <anysl/runtime.h>.
 *
 *===--------------------------------------------------------------------------------------------===*/

#ifndef ANYSL_ABI_H
#define ANYSL_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Changes when any structure below does; a library of another version is refused. */
#define ANYSL_ABI_VERSION 7
/** The first field of AnyslLibraryInfo: "AnSL" read as a little-endian number. */
#define ANYSL_MAGIC 0x4c536e41u
/** The one symbol that a shader library exports, an AnyslLibraryInfo. */
#define ANYSL_LIBRARY_SYMBOL "anysl_library"

/** The shader globals, by the names of Globals.def: ANYSL_P, ANYSL_N, ... */
typedef enum AnyslGlobal {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_##name = id,
#include <anysl/Globals.def>
  ANYSL_GLOBAL_COUNT
} AnyslGlobal;

/** Where each global's first component lies among all components: ANYSL_COMPONENT_P = 0, ..._N = 3
 */
enum {
  ANYSL_COMPONENT_START = -1,
#define ANYSL_GLOBAL(id, name, type, components, storage, doc)                                     \
  ANYSL_COMPONENT_##name, ANYSL_COMPONENT_LAST_##name = ANYSL_COMPONENT_##name + (components) - 1,
#include <anysl/Globals.def>
  ANYSL_COMPONENT_COUNT
};

typedef enum AnyslType {
  ANYSL_FLOAT = 1,
  ANYSL_COLOR,
  ANYSL_POINT,
  ANYSL_VECTOR,
  ANYSL_NORMAL,
  ANYSL_MATRIX,
  ANYSL_STRING
} AnyslType;

typedef enum AnyslShaderKind {
  ANYSL_SURFACE = 1,
  ANYSL_DISPLACEMENT,
  ANYSL_LIGHT,
  ANYSL_VOLUME,
  ANYSL_IMAGER,
  ANYSL_METHOD /**< a method of a class shader, called by other shaders */
} AnyslShaderKind;

/** How a runtime finds the globals of a point. */
typedef enum AnyslLayout {
  /** globals[component] points to one array per component (structure of arrays). */
  ANYSL_LAYOUT_SOA = 1,
  /** globals[0] points to an array of points, each ANYSL_COMPONENT_COUNT reals (array of
     structures). */
  ANYSL_LAYOUT_AOS
} AnyslLayout;

/** The number format of a batch's arrays. */
typedef enum AnyslReal { ANYSL_REAL_FLOAT = 1, ANYSL_REAL_DOUBLE } AnyslReal;

/** One component of a uniform parameter: a number (whatever the library's real), or text. */
typedef union AnyslCell {
  double number;
  const char *string;
} AnyslCell;

typedef enum AnyslLightKind {
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence) ANYSL_LIGHT_##name = id,
#include <anysl/LightKinds.def>
  ANYSL_LIGHT_SHADER = 4 /**< what a light shader computes, asked for by the service `light` */
} AnyslLightKind;

enum {
  ANYSL_LIGHT_CASTS_SHADOW = 1,
  ANYSL_LIGHT_NONDIFFUSE = 2,
  ANYSL_LIGHT_NONSPECULAR = 4,
  ANYSL_LIGHT_AMBIENT = 8, /**< shader: only ambient() sees it */
  ANYSL_LIGHT_FAR = 16,    /**< shader: L is a direction, so that shadows come from far away */
  ANYSL_LIGHT_COMPUTES_FLAGS =
      32 /**< shader: __nondiffuse or __nonspecular are results of its own */
};

/** A light, in the shaders' ("current") space. Of the standard kinds none is ambient. */
typedef struct AnyslLight {
  uint32_t kind;      /**< AnyslLightKind */
  uint32_t flags;     /**< ANYSL_LIGHT_... */
  float color[3];     /**< light colour times intensity; shader: what its Cl is multiplied by */
  float from[3];      /**< position (point, spot); shader: its P */
  float direction[3]; /**< unit vector in which the light travels (distant, spot); shader: its N */
  float cos_outer;    /**< spot: no light where the angle's cosine is below this */
  float cos_inner;    /**< spot: full light where it is above this */
  float beam;         /**< spot: exponent of the cosine */
  const char *category; /**< the categories that it belongs to, comma-separated; null: none */
  const void
      *shader; /**< shader: whose results these are, for libanysl a `const AnyslInstance *`;
                  standard: null, or its AnyslStandardLight, for values that are sent to it */
  const char
      *handle; /**< what getlights() calls it, a name that call_method knows; null: left out */
  const AnyslCell *params; /**< shader: its parameters' values, for where its code is linked into
                              surfaces; null: it is not to be run there */
  uint64_t code;           /**< shader: which code it runs, as in AnyslShaderInfo */
} AnyslLight;

struct AnyslShadeArgs;

/** AnyslTextureRequest::fill of a lookup that gives none. */
#define ANYSL_NO_FILL 1e30f

/** What a lookup in a picture asks for; the same for all points of a call. */
typedef struct AnyslTextureRequest {
  uint32_t struct_size;
  uint32_t channels; /**< how many values: 1 or 3 */
  uint32_t first_channel;
  uint32_t samples;   /**< shadow: how many depths to compare */
  const char *name;   /**< of the file, never null */
  const char *filter; /**< between texels; "": the renderer's choice */
  const char *swrap;  /**< outside of [0, 1] along s; "": what the file says */
  const char *twrap;
  float fill; /**< of channels that the file lacks; ANYSL_NO_FILL: none given */
  float bias; /**< shadow: by how much a depth must be nearer than the point */
} AnyslTextureRequest;

/** Where to look: for each number an array with one element a point. */
typedef struct AnyslTexturePoints {
  uint32_t struct_size;
  const float *at[3]; /**< texture: s and t; environment: a direction; shadow: a point */
  const float *dx[3]; /**< the filter's axes: the edges of a parallelogram about that place */
  const float *dy[3];
  const float *blur[2]; /**< what to add to the filter along s and t, as a share of the picture */
  /** Null, or, for each number of `at`, where to put how the values change with it, laid out like
      the values: asked for where a shader reads a derivative of what it looked up. Neutral: 0,
      which is there already. */
  float *result_by[3];
} AnyslTexturePoints;

/**
 * A lookup for `width` points (at most 16) from `first` on; bit i of `mask` says that point first +
 * i asks. Value c of point i goes to result[c * width + i].
 */
typedef void AnyslTextureService(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                                 uint32_t width, uint32_t mask, const AnyslTextureRequest *request,
                                 const AnyslTexturePoints *points, float *result);

/**
 * Values that one shader hands to another, or asks for. `what` names them; their numbers lie one
 * after the other in `numbers`, their texts in `texts`. A value is described by a letter, f for a
 * float, t for a color, point, vector or normal, m for a matrix (row by row), s for text, and, of
 * an array, its length: f4. f*4 is an array of at most four floats, whose length lies in `numbers`
 * before them; there is room for all. Names and letters are apart by colons, values by commas:
 * "intensity:f,from:t,name:s".
 */
typedef struct AnyslMessage {
  uint32_t struct_size;
  uint32_t number_count;
  uint32_t text_count;
  uint32_t reserved;
  const char *what;
  double *numbers;
  const char **texts; /**< never null pointers in it */
} AnyslMessage;

/**
 * How rays change from point to point, for each number an array with one element a point: the
 * derivatives of their origins P and directions R (of any length) by u and v, and du and dv of the
 * points, how far the next one lies.
 */
typedef struct AnyslRayDerivatives {
  uint32_t struct_size;
  const float *P_by_u[3];
  const float *P_by_v[3];
  const float *R_by_u[3];
  const float *R_by_v[3];
  const float *du;
  const float *dv;
} AnyslRayDerivatives;

/** Of what along a ray color and opacity are asked for. */
typedef enum AnyslHitShading {
  ANYSL_SHADE_NOTHING,
  ANYSL_SHADE_FIRST, /**< the surface that is met, alone */
  ANYSL_SHADE_ALL    /**< that one and all behind it that it lets through */
} AnyslHitShading;

/** What rays meet first, for each number an array with one element a point. */
typedef struct AnyslHits {
  uint32_t struct_size;
  uint32_t shades; /**< AnyslHitShading: whether color and opacity are asked for, and of what */
  float *distance; /**< along the direction of unit length; below 0: nothing was met */
  float *N[3];     /**< the shading normal there, of unit length, facing the ray's origin */
  float *Ng[3];    /**< the geometric normal there, likewise */
  float *color[3]; /**< what the surface sends back; of a ray that met nothing, what arrives */
  float *opacity[3]; /**< of that surface; of a ray that met nothing, how much of all else it hides */
  AnyslMessage *values; /**< one for each point, or null: what else is asked about a surface, named
                             "surface:NAME", "displacement:NAME" (parameters of the shader, after it
                             has run), "primitive:NAME" (a primitive variable) or "attribute:NAME";
                           what is not there is left as it is */
  const AnyslRayDerivatives *change; /**< how the rays change; null: it is not known */
  const char *kind;   /**< what the rays are for: "diffuse", a mean over many directions; "specular";
                           "transmission", of which only the opacity is asked for, up to the reach;
                           never null, and neither are the others */
  const char *subset; /**< the surfaces that they see, by the names of sets, separated by commas;
                           those behind a - are not seen; "": all */
  const char *sides;  /**< and their sides: "front", "back"; else both */
} AnyslHits;

/** What shaders ask for by name, by the names of QueryKinds.def: ANYSL_QUERY_attribute, ... */
typedef enum AnyslQueryKind {
#define ANYSL_QUERY(id, name, storage, doc) ANYSL_QUERY_##name = id,
#include <anysl/QueryKinds.def>
  ANYSL_QUERY_KIND_COUNT,
  ANYSL_QUERY_PRIMITIVE = 0 /**< a primitive variable, of what a ray has met */
} AnyslQueryKind;

#define ANYSL_ANY_LENGTH 0xffffffffu

/** One question: attribute("user:weights", w) for one element of w. */
typedef struct AnyslQuery {
  uint32_t kind;         /**< AnyslQueryKind */
  uint32_t type;         /**< AnyslType of the variable; ANYSL_VECTOR also for points and normals */
  uint32_t array_length; /**< of the variable; 0: not an array; ANYSL_ANY_LENGTH: the value's, and
                            an element that it does not have gives 0 */
  uint32_t element;      /**< of the variable: which of its elements is wanted */
  uint32_t light;        /**< lightsource: the light's number in AnyslShadeArgs::lights */
  uint32_t reserved;
  const char *name;    /**< never null */
  const char *subject; /**< textureinfo: the file; else "" */
} AnyslQuery;

/**
 * What a renderer does for its shaders. A null function is one that the renderer does not offer;
 * asking for it gives the stated neutral value. Every function may be called by many threads at
 * once.
 *
 * The packet forms serve `width` consecutive points from `first` at once; bit i of `mask` says that
 * point first + i asks. Vectors lie as x[width] y[width] z[width]; results of points that do not
 * ask are ignored.
 */
typedef struct AnyslServices {
  uint32_t struct_size;
  /** The light arriving at P from direction R (need not be of unit length). Neutral: black. */
  void (*trace)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                const double P[3], const double R[3], double color[3]);
  void (*trace_packet)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                       uint32_t width, uint32_t mask, const float *P, const float *R, float *color);
  /** The distance from P to the first surface in direction R. Neutral: 1e30. */
  double (*trace_distance)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                           const double P[3], const double R[3]);
  void (*trace_distance_packet)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                                uint32_t width, uint32_t mask, const float *P, const float *R,
                                float *distance);
  /** How much light passes from one point to another. Neutral: all of it (1). */
  void (*transmission)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                       const double from[3], const double to[3], double color[3]);
  void (*transmission_packet)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                              uint32_t width, uint32_t mask, const float *from, const float *to,
                              float *color);
  /** The matrix (row by row, for row vectors) between named coordinate systems; returns 0 and
     leaves the matrix alone where a name is unknown. Neutral: identity. */
  int (*space_matrix)(void *renderer, const struct AnyslShadeArgs *args, const char *from,
                      const char *to, double matrix[16]);
  /**
   * Text made while shading. libanysl has these; where they are null, its own count
   * (lib/Host/Text.h), so that a renderer only gives what it wants to do otherwise, commonly
   * `print`. A format has directives (<anysl/format.h>), numbered from 0; a value of AnyslType
   * `type` lies in as many cells as that has components; type 0 stands for the rest of the format
   * behind its first `index` directives.
   *
   * append: the text, then format from behind directive index - 1 up to directive `index`, then the
   * value as the directive says. What it returns lives at least as long as the renderer shades and
   * instances exist; equal arguments may give the same pointer. Neutral: the text.
   */
  const char *(*append)(void *renderer, const char *text, const char *format, uint32_t index,
                        uint32_t type, const AnyslCell *value);
  /** Adds the same to the line that a point prints; type 0 also prints the line. Neutral: nothing.
   */
  void (*print_value)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                      const char *format, uint32_t index, uint32_t type, const AnyslCell *value);
  /** Whether a POSIX basic regular expression is found in a text. Neutral: 0. */
  int (*match)(void *renderer, const char *pattern, const char *text);
  /** What printf() made for one point; line ends are in the text. Called by libanysl's print_value.
      libanysl's own writes to the standard output. */
  void (*print)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                const char *text);
  /** Values out of a picture. Neutral: 0. */
  AnyslTextureService *texture;
  /** Values out of a picture of all directions. Neutral: 0. */
  AnyslTextureService *environment;
  /** How much of a filter is in shadow, by a picture of depths. Neutral: 0. */
  AnyslTextureService *shadow;
  /** What rays from P (x, y and z, an array each) along R (of any length) meet within `reach`, for
      `width` points (at most 16) from `first` on; of the others `hits` stays as it is. Neutral:
      nothing. */
  void (*trace_hit)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                    uint32_t width, uint32_t mask, const float *const P[3], const float *const R[3],
                    const float *reach, const AnyslHits *hits);
  /**
   * Runs the light shader args->lights[light] for a position P with normal N: nine numbers, L from
   * P to the light, Cl and Ol. L is zero where no light arrives. light, light_packet, light_value
   * and light_sent are libanysl's own where they are all null.
   */
  void (*light)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point, uint32_t light,
                const double P[3], const double N[3], double result[9]);
  void (*light_packet)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                       uint32_t width, uint32_t mask, uint32_t light, const float *P,
                       const float *N, float *result);
  /**
   * A parameter of any light as it is for that position, with what `sent` (null: nothing) tells it:
   * answers a question of kind `lightsource`, as `query` does. The standard kinds have
   * __nondiffuse,
   * __nonspecular, __category and from.
   */
  int (*light_value)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                     uint32_t light, const double P[3], const double N[3], const AnyslMessage *sent,
                     const AnyslQuery *query, AnyslCell *value);
  /**
   * Calls a method of another shader at one point. Gives 1 if there are such a shader and method,
   * else 0; libanysl's anysl_method_call() does it. message->what is "bump(tf3s)f"  a name, the
   * arguments' letters and the result's (v: none); numbers and texts are the arguments', and
   * afterwards what the method made of them; the result's lie behind
   *   ".Kd:f"        a parameter, which is set to its value if it is of this type or one that
   * converts
   *   ""             whether there is such a shader
   * Neutral: 0.
   */
  int (*call_method)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                     const char *shader, AnyslMessage *message);
  /** The name of shader number `index` among those of a category (""; all) that methods of can be
      called; null behind the last. Neutral: there are none. */
  const char *(*shader_name)(void *renderer, const struct AnyslShadeArgs *args,
                             const char *category, uint32_t index);
  /**
   * Answers a question. If there is such a thing and the variable can take its value as the shading
   * language would assign it (anysl_answer() of libanysl decides), sets `value`, as many cells as
   * the type has components, and returns 1; else returns 0. `point` asks; it is 0 where
   * QueryKinds.def says `uniform`. Such a question is asked once for many points. The name
   * ANYSL_QUERY_SHADER_NAME asks for a shader's own name. While defaults are computed, args->batch
   * is null. Neutral: 0.
   */
  int (*query)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
               const AnyslQuery *query, AnyslCell *value);
  /** As `light`, of a light shader whose parameters named in `sent` have these values, if they can
     take them as the shading language would assign them. One of the four that are libanysl's own.
   */
  void (*light_sent)(void *renderer, const struct AnyslShadeArgs *args, uint32_t point,
                     uint32_t light, const double P[3], const double N[3], const AnyslMessage *sent,
                     double result[9]);
  /** Something that a shader cannot do and leaves out, with its place. libanysl's own writes each
     text once, to the standard error output. */
  void (*warn)(void *renderer, const struct AnyslShadeArgs *args, const char *text);
  /** As trace_packet, for rays of which is known how they change, so that what they meet knows how
      much of it a pixel sees; P, R and the colour have an array for each component. Where it is
     null, or the shader's numbers carry no derivatives, trace or trace_packet is asked. */
  void (*trace_derivatives)(void *renderer, const struct AnyslShadeArgs *args, uint32_t first,
                            uint32_t width, uint32_t mask, const float *const P[3],
                            const float *const R[3], const AnyslRayDerivatives *change,
                            float *const color[3]);
} AnyslServices;

/** The name by which a shader asks for the name of another, or of itself, as a string. */
#define ANYSL_QUERY_SHADER_NAME "shadername"

/** A batch of points that share one set of parameters. The host fills it; shaders change only
 * outputs. */
typedef struct AnyslShadeArgs {
  uint32_t struct_size;
  uint32_t count;              /**< points in the arrays; they are readable and writable up to a
                                    multiple of 16 points */
  AnyslCell *params;           /**< AnyslShaderInfo::cell_count cells */
  const uint8_t *param_is_set; /**< one byte a parameter: bit ANYSL_PARAM_GIVEN, that the host has
                                    given it, where defaults are computed; ANYSL_PARAM_ONLY_OUT,
                                  that its array in param_data is for results alone, where shading;
                                    ANYSL_PARAM_HALF, that its array there holds halves */
  void *const *param_data; /**< one pointer a parameter, or null: its values point by point; null
                                pointer where it has none. Component c of array element e at
                                point p of a type with n components is at
                                SoA: [(e*n + c) * data_stride + p],
                                AoS: [(e * data_stride + p) * n + c] */
  void *const *param_by_u; /**< the derivatives of those values by u, laid out alike; null, or null
                                for a parameter: 0. Only of parameters with
                                ANYSL_PARAM_DIFFERENTIATED are they read */
  void *const *param_by_v; /**< and by v */
  void *const *globals;    /**< as AnyslLayout says; only those the shader names need be there.
                                Uniform globals: SoA one value, AoS taken from each point */
  size_t data_stride;      /**< in param_data: points from one component (SoA) or array element
                                (AoS) to the next */
  const uint32_t *seeds;   /**< start of each point's random sequence; null: the point's number */
  const AnyslServices *services; /**< never null */
  void *renderer;                /**< handed back to every service */
  void *batch;                   /**< the renderer's own, untouched */
  const AnyslLight *lights;      /**< the lights that shine on this batch */
  uint32_t light_count;
  float ambient[3];                       /**< sum of the ambient lights that are no shaders */
  const struct AnyslLibraryInfo *library; /**< the shader's own: how the arrays are laid out; may be
                                       null, and then light shaders see nothing of them */
  uint64_t globals_given; /**< bit ANYSL_P and so on: which globals hold values, for light
                               shaders to see the ones that they read */
  void *light_cache;      /**< libanysl's: keeps what light shaders gave as long as one call
                               shades; null: they run each time */
} AnyslShadeArgs;

/** In AnyslShadeArgs::param_is_set */
enum {
  ANYSL_PARAM_GIVEN = 1,
  ANYSL_PARAM_ONLY_OUT = 2,
  ANYSL_PARAM_HALF = 4 /**< 16-bit floating-point numbers (IEEE 754 binary16), for libraries with
                            AnyslLibraryInfo::reads_half; never of an output parameter */
};

/** Shades points [first, last). Thread safe as long as batches differ. */
typedef void (*AnyslShadeFunction)(const AnyslShadeArgs *args, uint32_t first, uint32_t last);

enum {
  ANYSL_PARAM_VARYING = 1,
  ANYSL_PARAM_OUTPUT = 2,
  ANYSL_PARAM_FIXED = 4,         /**< given to anysl-link */
  ANYSL_PARAM_DIFFERENTIATED = 8 /**< the shader reads its derivatives where it has values point by
                                      point */
};

typedef struct AnyslParamInfo {
  const char *name;
  uint32_t type;         /**< AnyslType */
  uint32_t flags;        /**< ANYSL_PARAM_... */
  uint32_t array_length; /**< 0: not an array */
  uint32_t first_cell;   /**< in AnyslShadeArgs::params */
} AnyslParamInfo;

typedef struct AnyslEntryInfo {
  uint32_t width; /**< points at once: 1, 4, 8, 16 */
  AnyslShadeFunction shade;
} AnyslEntryInfo;

typedef struct AnyslShaderInfo {
  const char *name;
  uint32_t kind; /**< AnyslShaderKind */
  uint32_t param_count;
  const AnyslParamInfo *params;
  uint32_t cell_count;
  uint32_t entry_count;
  const AnyslEntryInfo *entries;
  uint64_t globals_read; /**< bit ANYSL_P is set if the shader reads P, and so on */
  uint64_t globals_written;
  uint32_t services; /**< bit i: service i of lib/STC/Services.def is asked for */
  uint32_t effects;  /**< bit i: effect i of lib/STC/Effects.def is there */
  /** Computes the defaults of the parameters that param_is_set does not name, into params. */
  void (*init)(const AnyslShadeArgs *args);
  uint64_t code; /**< of source, real and math tier: where it is the same, so is what comes out */
} AnyslShaderInfo;

typedef struct AnyslLibraryInfo {
  uint32_t magic;
  uint32_t abi_version;
  uint32_t struct_size;
  uint32_t layout;          /**< AnyslLayout */
  uint32_t real;            /**< AnyslReal of the batch's arrays */
  uint32_t global_count;    /**< ANYSL_GLOBAL_COUNT when the library was made */
  uint32_t component_count; /**< ANYSL_COMPONENT_COUNT likewise */
  uint32_t shade_args_size; /**< sizeof(AnyslShadeArgs) likewise */
  uint32_t services_size;   /**< sizeof(AnyslServices) likewise */
  uint32_t shader_count;
  const AnyslShaderInfo *shaders;
  const char *producer;     /**< "AnySL 0.1.0" */
  const char *runtime;      /**< "packet" */
  const char *real_name;    /**< "float" */
  const char *math;         /**< "u10" */
  const char *target_cpu;   /**< as LLVM names it */
  const char *cpu_features; /**< what the code needs, comma-separated x86 names: "avx2,fma" */
  uint32_t reads_half;      /**< whether it looks for ANYSL_PARAM_HALF */
  uint32_t reserved;
} AnyslLibraryInfo;

#ifdef __cplusplus
}
#endif

#endif
