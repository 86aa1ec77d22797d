/*===-- anysl/anysl.h - how a renderer loads and runs shaders -----------------------------*- C
 *-*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===
 *
 * The host side in C99: link with -lanysl, no LLVM needed. docs/host-guide.md explains it with an
 * example, examples/host-c is that example.
 *
 *     AnyslLibrary *library;    a shader library on disk, opened once, used by all threads
 *     AnyslInstance *instance;  one shader with values for its parameters; constant while it shades
 *     AnyslBatch *batch;        points to shade with their globals; one thread's own
 *
 *     if (anysl_library_open("wood.so", 0, &library) != ANYSL_OK)
 *       return fail(anysl_last_error());
 *     anysl_instance_create(library, "wood", NULL, NULL, &instance);
 *     anysl_batch_create(instance, 4096, 0, &batch);
 *     anysl_batch_write_float(batch, ANYSL_P, 0, count, positions, 3);
 *     anysl_shade(instance, batch, 0, count, 0);
 *     anysl_batch_read_float(batch, ANYSL_Ci, 0, count, colors, 3);
 *
 * Every function that can fail returns an AnyslStatus and leaves its results alone when it does;
 * anysl_last_error() then says what is wrong in a sentence. Freeing a null pointer does nothing. A
 * renderer that keeps its own arrays needs no AnyslBatch: see anysl_instance_fill_args().
 *
 *===--------------------------------------------------------------------------------------------===*/

#ifndef ANYSL_ANYSL_H
#define ANYSL_ANYSL_H

#include <anysl/abi.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Grows by one whenever this header gains a function; functions never change their meaning. */
#define ANYSL_API_VERSION 4
#define ANYSL_API __attribute__((visibility("default")))

/* The structures of <anysl/abi.h> as libraries and renderers were compiled with them. */
#define ANYSL_ASSERT_SIZE(type, size)                                                              \
  typedef char anysl_size_of_##type[sizeof(void *) != 8 || sizeof(type) == (size) ? 1 : -1]
ANYSL_ASSERT_SIZE(AnyslCell, 8);
ANYSL_ASSERT_SIZE(AnyslLight, 96);
ANYSL_ASSERT_SIZE(AnyslServices, 200);
ANYSL_ASSERT_SIZE(AnyslTextureRequest, 56);
ANYSL_ASSERT_SIZE(AnyslTexturePoints, 120);
ANYSL_ASSERT_SIZE(AnyslHits, 152);
ANYSL_ASSERT_SIZE(AnyslRayDerivatives, 120);
ANYSL_ASSERT_SIZE(AnyslShadeArgs, 144);
ANYSL_ASSERT_SIZE(AnyslQuery, 40);
ANYSL_ASSERT_SIZE(AnyslParamInfo, 24);
ANYSL_ASSERT_SIZE(AnyslEntryInfo, 16);
ANYSL_ASSERT_SIZE(AnyslShaderInfo, 80);
ANYSL_ASSERT_SIZE(AnyslLibraryInfo, 104);
#undef ANYSL_ASSERT_SIZE

typedef struct AnyslLibrary AnyslLibrary;
typedef struct AnyslInstance AnyslInstance;
typedef struct AnyslBatch AnyslBatch;

typedef enum AnyslStatus {
  ANYSL_OK = 0,
  ANYSL_ERROR_OPEN, /**< the file is missing, unreadable, or refused by the dynamic linker */
  ANYSL_ERROR_NOT_A_LIBRARY, /**< a shared object, but not one that anysl-link wrote, or damaged */
  ANYSL_ERROR_VERSION,       /**< made for another version of the binary interface */
  ANYSL_ERROR_CPU,           /**< needs instructions that this processor lacks */
  ANYSL_ERROR_NAME,          /**< no shader, parameter or global of that name */
  ANYSL_ERROR_TYPE,          /**< a value of the wrong type or number of components */
  ANYSL_ERROR_RANGE,         /**< points outside the batch, or a width that the shader has not */
  ANYSL_ERROR_STATE,         /**< not allowed with this object: the message says why */
  ANYSL_ERROR_MEMORY         /**< out of memory */
} AnyslStatus;

/*===-- Versions, errors, names -------------------------------------------===*/

/** The ANYSL_ABI_VERSION that the linked libanysl was compiled with. */
ANYSL_API uint32_t anysl_abi_version(void);
/** The ANYSL_API_VERSION that the linked libanysl was compiled with. */
ANYSL_API uint32_t anysl_api_version(void);
/** "0.1.0" */
ANYSL_API const char *anysl_version_string(void);

/** What the calling thread's last failed call had to say, file name included; "" before any
   failure. Valid until that thread's next failure. */
ANYSL_API const char *anysl_last_error(void);

/** "color"; "?" for no AnyslType. */
ANYSL_API const char *anysl_type_name(uint32_t type);
/** Numbers (or texts) in a value of a type: 1, 3 or 16; 0 for no AnyslType. */
ANYSL_API uint32_t anysl_type_components(uint32_t type);
/** "surface"; "?" for no AnyslShaderKind. */
ANYSL_API const char *anysl_kind_name(uint32_t kind);
/** "Ci"; null for no AnyslGlobal. */
ANYSL_API const char *anysl_global_name(int global);
/** The AnyslGlobal of a name, or -1. */
ANYSL_API int anysl_global_find(const char *name);
/** Numbers a point: 1 or 3; 0 for no AnyslGlobal. */
ANYSL_API uint32_t anysl_global_components(int global);
/** The AnyslType of a global; 0 for no AnyslGlobal. */
ANYSL_API uint32_t anysl_global_type(int global);
/** Whether a global has one value for all points of a batch. */
ANYSL_API int anysl_global_is_uniform(int global);

/*===-- Libraries -----------------------------------------------------------===*/

/** Opens a library for looking at only: a processor that lacks instructions is no reason to refuse,
   and no shader of it can be instantiated. */
#define ANYSL_OPEN_INSPECT 1u

/**
 * Loads a shader library. A relative path is relative to the current folder, never searched for.
 * Checked before anything of it runs: that it is a shader library, its binary interface, number
 * format, layout and tables, and that this processor has all instructions that it uses. The
 * floating-point environment (MXCSR) is the same afterwards, whatever start-up code the file
 * contains.
 */
ANYSL_API AnyslStatus anysl_library_open(const char *path, uint32_t flags, AnyslLibrary **library);

/** The same checks for shaders that are part of the program, linked from an object file of
   anysl-link's.
    \p name stands for the file's name in messages. */
ANYSL_API AnyslStatus anysl_library_adopt(const AnyslLibraryInfo *info, const char *name,
                                          uint32_t flags, AnyslLibrary **library);

/** Lets go of a library. It stays loaded until its last instance and batch are freed as well. */
ANYSL_API void anysl_library_close(AnyslLibrary *library);

/** Everything the library says of itself, valid as long as it is loaded. */
ANYSL_API const AnyslLibraryInfo *anysl_library_info(const AnyslLibrary *library);
/** The path it was opened by. */
ANYSL_API const char *anysl_library_path(const AnyslLibrary *library);

/** The shader of a name; a null name means the library's first. Shaders of different kinds may have
   one name (a class shader's do): "displacement:glass" says which, "glass" means the first of them.
   Null if there is none, with a message. */
ANYSL_API const AnyslShaderInfo *anysl_library_shader(const AnyslLibrary *library,
                                                      const char *name);
/** The parameter of a name, or null. */
ANYSL_API const AnyslParamInfo *anysl_shader_param(const AnyslShaderInfo *shader, const char *name);
/** The code that shades \p width points at once; width 0 means the widest. Null if there is none.
 */
ANYSL_API AnyslShadeFunction anysl_shader_entry(const AnyslShaderInfo *shader, uint32_t width);
/** The widest of the shader's widths. */
ANYSL_API uint32_t anysl_shader_widest(const AnyslShaderInfo *shader);

/*===-- Instances -----------------------------------------------------------===*/

/**
 * A shader whose parameters have their defaults. \p services is what the renderer offers (null:
 * nothing) and is copied; \p renderer is handed back to every service. Both are also there while
 * defaults are computed, for `point "shader" (…)` and its like.
 */
ANYSL_API AnyslStatus anysl_instance_create(AnyslLibrary *library, const char *shader,
                                            const AnyslServices *services, void *renderer,
                                            AnyslInstance **instance);
ANYSL_API void anysl_instance_free(AnyslInstance *instance);
ANYSL_API const AnyslShaderInfo *anysl_instance_shader(const AnyslInstance *instance);

/**
 * Gives a parameter a value, as \p count numbers: all components of all array elements. As in the
 * shading language a single number does for a colour, point, vector or normal (that number three
 * times) and for a matrix (that multiple of the identity). An array that has a parameter
 * "NAME.length" beside it may get fewer elements than it has room for; that parameter is set with
 * it. Defaults that depend on this parameter are computed anew.
 */
ANYSL_API AnyslStatus anysl_instance_set_numbers(AnyslInstance *instance, const char *param,
                                                 const double *values, size_t count);
/** The same for a string parameter, one text for each array element. The texts are copied. */
ANYSL_API AnyslStatus anysl_instance_set_strings(AnyslInstance *instance, const char *param,
                                                 const char *const *values, size_t count);
/** Gives a parameter its default again. */
ANYSL_API AnyslStatus anysl_instance_unset(AnyslInstance *instance, const char *param);

/** A parameter's value, be it given or its default: exactly \p count numbers, all components. */
ANYSL_API AnyslStatus anysl_instance_get_numbers(const AnyslInstance *instance, const char *param,
                                                 double *values, size_t count);
/** The same for a string parameter; the texts live until the parameter is next set. */
ANYSL_API AnyslStatus anysl_instance_get_strings(const AnyslInstance *instance, const char *param,
                                                 const char **values, size_t count);

/**
 * Answers an AnyslQuery with a value that the renderer has: \p cells, as many as the components of
 * all its elements (\p array_length 0: not an array). Returns 1 and sets \p value if the variable
 * can take it: of the same length, and of the same type or of one that converts as in the shading
 * language (a float to anything but text; colours, points, vectors and normals to each other).
 * A variable of ANYSL_ANY_LENGTH takes an element of any array that has it.
 */
ANYSL_API int anysl_answer(const AnyslQuery *query, uint32_t type, uint32_t array_length,
                           const AnyslCell *cells, AnyslCell *value);

/**
 * Answers an AnyslQuery from a shader's parameters, or its name (ANYSL_QUERY_SHADER_NAME): what the
 * arrays of \p args (null: there are none) have for \p point, of parameters that are bound point by
 * point and of output parameters, else the instance's own value. Texts live as long as the instance
 * is not changed.
 */
ANYSL_API int anysl_instance_answer(const AnyslInstance *instance, const AnyslShadeArgs *args,
                                    uint32_t point, const AnyslQuery *query, AnyslCell *value);

/** Number \p at of the array that args->param_data has for parameter \p param, whatever its format;
   args->library has to be there. */
ANYSL_API double anysl_param_number(const AnyslShadeArgs *args, uint32_t param, size_t at);

/** For renderers with arrays of their own: fills in what the instance knows (struct_size, params,
    param_is_set, services, renderer, library) and sets the rest to null. The caller sets count,
   globals and what else it has, and calls a function of anysl_shader_entry() on it. */
ANYSL_API void anysl_instance_fill_args(const AnyslInstance *instance, AnyslShadeArgs *args);

/**
 * Calls a public method of a class shader, of which \p instance is any shader, at one point of
 * another shader's batch, or reads a parameter: what a renderer does in AnyslServices::call_method,
 * which describes \p message. Gives 1, or 0 where the class has no such method, the shader no such
 * parameter, or \p args lacks globals that the method names. For a method both libraries must have
 * one layout and number format.
 */
ANYSL_API int anysl_method_call(const AnyslInstance *instance, const AnyslShadeArgs *args,
                                uint32_t point, AnyslMessage *message);

/**
 * The same for the light of \p args that has this handle, which getlights() gave a shader. Of a
 * light of a standard kind it reads what AnyslServices::light_value knows. Gives 0 where there is
 * no such light.
 */
ANYSL_API int anysl_light_call(const AnyslShadeArgs *args, uint32_t point, const char *handle,
                               AnyslMessage *message);

/**
 * Sets the values that a message of AnyslHits asks for: \p ask is called with \p data and a
 * question of kind surface, displacement, attribute or ANYSL_QUERY_PRIMITIVE. Where it gives 0 the
 * value stays as it is.
 */
ANYSL_API void
anysl_message_answer(AnyslMessage *message,
                     int (*ask)(void *data, const AnyslQuery *query, AnyslCell *value), void *data);

/*===-- Batches -------------------------------------------------------------===*/

/**
 * Room for \p capacity points for an instance's shader: the globals that the shader reads or writes
 * and those of the mask \p more_globals (bit ANYSL_P and so on), all zero, in the library's number
 * format and layout, aligned to 64 bytes and padded to a multiple of 16 points. Any instance of the
 * same shader may shade it.
 */
ANYSL_API AnyslStatus anysl_batch_create(const AnyslInstance *instance, uint32_t capacity,
                                         uint64_t more_globals, AnyslBatch **batch);
ANYSL_API void anysl_batch_free(AnyslBatch *batch);

/** The globals the batch has room for, as a mask. */
ANYSL_API uint64_t anysl_batch_globals(const AnyslBatch *batch);
/** How many points are in use, at most the capacity; at first all. */
ANYSL_API AnyslStatus anysl_batch_set_count(AnyslBatch *batch, uint32_t count);
ANYSL_API uint32_t anysl_batch_count(const AnyslBatch *batch);

/**
 * Copies a global's values for points [first, first + count) into the batch. Point i takes its
 * components from values[(i - first) * stride]; stride 0 gives all points the same value. A uniform
 * global takes values[0..] and needs one point only. Globals that the batch has no room for are not
 * needed: they are passed over.
 */
ANYSL_API AnyslStatus anysl_batch_write_float(AnyslBatch *batch, int global, uint32_t first,
                                              uint32_t count, const float *values, size_t stride);
ANYSL_API AnyslStatus anysl_batch_write_double(AnyslBatch *batch, int global, uint32_t first,
                                               uint32_t count, const double *values, size_t stride);
/** Copies values out in the same arrangement. Here a global that the batch has no room for is an
 * error. */
ANYSL_API AnyslStatus anysl_batch_read_float(const AnyslBatch *batch, int global, uint32_t first,
                                             uint32_t count, float *values, size_t stride);
ANYSL_API AnyslStatus anysl_batch_read_double(const AnyslBatch *batch, int global, uint32_t first,
                                              uint32_t count, double *values, size_t stride);

/** What the batch's points are shaded with, but what an instance adds (parameters, services): for
   anysl_instance_answer(). */
ANYSL_API const AnyslShadeArgs *anysl_batch_args(const AnyslBatch *batch);

/** Where the first point's value of a component lies, for renderers that fill batches in place;
   null if the batch has no room for it. \p stride is set to the distance from point to point, in
   reals (0: uniform). */
ANYSL_API void *anysl_batch_global(AnyslBatch *batch, int global, uint32_t component,
                                   size_t *stride);

/** Gives a varying parameter's values point by point, as the globals are written. Points that are
   never written have zeros. The instance's own value no longer counts for this batch. */
ANYSL_API AnyslStatus anysl_batch_bind_float(AnyslBatch *batch, const char *param, uint32_t first,
                                             uint32_t count, const float *values, size_t stride);
ANYSL_API AnyslStatus anysl_batch_bind_double(AnyslBatch *batch, const char *param, uint32_t first,
                                              uint32_t count, const double *values, size_t stride);
/** The same from halves (IEEE 754 binary16), which the batch keeps as they are where the library
   reads halves (AnyslLibraryInfo::reads_half) and the parameter is no output, and converts
   elsewhere; results are the same. */
ANYSL_API AnyslStatus anysl_batch_bind_half(AnyslBatch *batch, const char *param, uint32_t first,
                                            uint32_t count, const uint16_t *values, size_t stride);
/** How those values change with u and v, for shaders that read that (ANYSL_PARAM_DIFFERENTIATED;
   others ignore it): laid out as the values, which must have been bound before. Without them, and
   at points that are never written, derivatives are 0. */
ANYSL_API AnyslStatus anysl_batch_bind_derivatives_float(AnyslBatch *batch, const char *param,
                                                         uint32_t first, uint32_t count,
                                                         const float *by_u, const float *by_v,
                                                         size_t stride);
ANYSL_API AnyslStatus anysl_batch_bind_derivatives_double(AnyslBatch *batch, const char *param,
                                                          uint32_t first, uint32_t count,
                                                          const double *by_u, const double *by_v,
                                                          size_t stride);
/** Asks for an output parameter, so that shading stores it. */
ANYSL_API AnyslStatus anysl_batch_want_output(AnyslBatch *batch, const char *param);
/** An output parameter's values; it must have been asked for before shading. */
ANYSL_API AnyslStatus anysl_batch_read_output_float(const AnyslBatch *batch, const char *param,
                                                    uint32_t first, uint32_t count, float *values,
                                                    size_t stride);
ANYSL_API AnyslStatus anysl_batch_read_output_double(const AnyslBatch *batch, const char *param,
                                                     uint32_t first, uint32_t count, double *values,
                                                     size_t stride);
/** The same for texts, which live as long as the library, the instance and the renderer's services
   that made them. */
ANYSL_API AnyslStatus anysl_batch_read_output_strings(const AnyslBatch *batch, const char *param,
                                                      uint32_t first, uint32_t count,
                                                      const char **values, size_t stride);
/** Takes the arrays of a parameter away again: bound values or a wanted output. */
ANYSL_API AnyslStatus anysl_batch_unbind(AnyslBatch *batch, const char *param);

/** The lights that shine on the batch and the sum of the ambient ones (null: black). \p lights is
   kept, not copied. */
ANYSL_API void anysl_batch_set_lights(AnyslBatch *batch, const AnyslLight *lights, uint32_t count,
                                      const float ambient[3]);
/**
 * Makes a light of an instance of a light shader, for illuminance and ambient() to run. P is the
 * origin of the shader's own space and N its z axis, as the instance's space_matrix("shader",
 * "current") has them; flags and category come from its parameters __nondiffuse, __nonspecular and
 * __category. All that may be changed afterwards. The light is valid as long as the instance, and
 * has to be made again where a parameter of the instance is set.
 */
ANYSL_API AnyslStatus anysl_light_from_instance(const AnyslInstance *instance, AnyslLight *light);

/** The parameters of the standard's light sources, in the shaders' ("current") space. */
typedef struct AnyslStandardLight {
  float intensity, color[3];
  float from[3], to[3];
  float cone_angle, cone_delta_angle; /**< radians */
  float beam_distribution;
  float share; /**< what its light is multiplied by besides: 1, of an area light its part */
} AnyslStandardLight;

/** "distantlight" with no parameter set, and so on: intensity and color 1, from the origin towards
   +z, 30 and 5 degrees, beam 2. */
ANYSL_API void anysl_standard_light_defaults(AnyslStandardLight *values);
/** Makes a light of a standard kind, whose `shader` is null; a renderer that sets it to \p values,
   which must then live as long, lets surfaces ask for all of them and send others. The light is to
   the last bit what examples/shaders/distantlight.sl, pointlight.sl and spotlight.sl compute.
   `from` and `to` must differ, but for a point light. */
ANYSL_API AnyslStatus anysl_light_standard(uint32_t kind, const AnyslStandardLight *values,
                                           AnyslLight *light);

/** The globals that light shaders among the lights read and get from the surface, as bits for
   anysl_batch_create(): where the batch has no room for one, the light sees zeros. */
ANYSL_API uint64_t anysl_lights_globals(const AnyslLight *lights, uint32_t count);
/**
 * For renderers with arrays of their own: what light shaders compute for points of \p args is kept
 * from here to anysl_lights_end(), on this thread. Pairs may nest. Without them, and with them, the
 * results are the same.
 */
ANYSL_API void anysl_lights_begin(AnyslShadeArgs *args);
ANYSL_API void anysl_lights_end(AnyslShadeArgs *args);

/** The start of every point's random sequence, one number for each point of the capacity, copied;
   null: the point's number in the batch. */
ANYSL_API AnyslStatus anysl_batch_set_seeds(AnyslBatch *batch, const uint32_t *seeds);
/** A pointer for the renderer's own use, found as AnyslShadeArgs::batch by its services. */
ANYSL_API void anysl_batch_set_user(AnyslBatch *batch, void *user);

/**
 * Shades points [first, last) with the code that takes \p width points at once (0: the widest). One
 * library and one instance may be in use by any number of threads, and threads may shade disjoint
 * ranges of one batch, as long as nobody changes the instance or the batch meanwhile.
 */
ANYSL_API AnyslStatus anysl_shade(const AnyslInstance *instance, AnyslBatch *batch, uint32_t first,
                                  uint32_t last, uint32_t width);

#ifdef __cplusplus
}
#endif

#endif
