//===-- anysl/standard/lights.h - the lights of a batch ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Lights lie in AnyslShadeArgs. The standard kinds are evaluated in line: which kind a light is,
// and all of its data, are the same for every point, so widened code branches on the kind and
// computes the rest for all points at once. The formulas are those of the RenderMan Interface's
// standard light sources (version 3.2, appendix A.2.2), operation by operation those of
// examples/shaders/pointlight.sl and its like, so that either gives the same bits. A light of
// another shader is asked for through a function of the runtime's own, askLight(), as is one that
// casts shadows, through anysl_transmission.
//
// Of lights that are linked in (anysl-link --scene) the linker says what they are, in variables
// here: what is read of them are constants then, wherever a light's number is one.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_LIGHTS_H
#define ANYSL_STANDARD_LIGHTS_H

#include <anysl/demand.h>
#include <anysl/domain.h>
#include <anysl/standard/message.h>

/// Bits 1 << ANYSL_ASSUMES_...: what the scene does without that the library is linked for.
extern "C" __attribute__((weak)) const uint32_t anysl_scene_assumes = 0;
/// How many lights shine on every point, if they are linked in; 0: any number may.
extern "C" __attribute__((weak)) const uint32_t anysl_scene_light_count = 0;
/// Those lights.
extern "C" __attribute__((weak))
const AnyslLinkedLight anysl_scene_lights[ANYSL_MOST_LINKED_LIGHTS] = {};
/// Whether it is known what ambient lights add up to, and what that is.
extern "C" __attribute__((weak)) const uint32_t anysl_scene_ambient_known = 0;
extern "C" __attribute__((weak)) const float anysl_scene_ambient[3] = {};

namespace anysl {

inline bool sceneLacks(AnyslAssumption what) { return anysl_scene_assumes >> what & 1; }

//===-- A batch's lights ----------------------------------------------------------------------===//

inline uint32_t lightCount(const anysl_context *context) {
  return anysl_scene_light_count ? anysl_scene_light_count : context->args->light_count;
}

/// A light of the batch. What is linked in of it is not looked up there.
class Light {
public:
  Light(const anysl_context *context, int32_t index)
      : given(context->args->lights[index]), linked(anysl_scene_lights[index]) {}

  uint32_t kind() const { return anysl_scene_light_count ? linked.light.kind : given.kind; }
  uint32_t flags() const {
    uint32_t known = anysl_scene_light_count ? linked.known_flags : 0;
    // What only light shaders are.
    if (anysl_scene_light_count && linked.light.kind != ANYSL_LIGHT_SHADER)
      known |= ANYSL_LIGHT_AMBIENT | ANYSL_LIGHT_COMPUTES_FLAGS;
    return (given.flags & ~known) | (linked.light.flags & known);
  }
  auto &color() const { return with(ANYSL_KNOWN_COLOR).color; }
  auto &from() const { return with(ANYSL_KNOWN_FROM).from; }
  auto &direction() const { return with(ANYSL_KNOWN_DIRECTION).direction; }
  float cosOuter() const { return with(ANYSL_KNOWN_CONE).cos_outer; }
  float cosInner() const { return with(ANYSL_KNOWN_CONE).cos_inner; }
  float beam() const { return with(ANYSL_KNOWN_BEAM).beam; }
  const char *category() const { return with(ANYSL_KNOWN_CATEGORY).category; }
  const char *handle() const { return given.handle; }
  const void *shader() const { return given.shader; }
  const AnyslCell *params() const { return given.params; }
  bool isShader() const {
    return !sceneLacks(ANYSL_ASSUMES_NO_LIGHT_SHADERS) && kind() == ANYSL_LIGHT_SHADER;
  }

private:
  const AnyslLight &with(uint32_t field) const {
    return anysl_scene_light_count && linked.known & field ? linked.light : given;
  }

  const AnyslLight &given;
  const AnyslLinkedLight &linked;
};

//===-- What a runtime defines ----------------------------------------------------------------===//

/// The service `light`: L is zero where the light does not reach P.
void askLight(anysl_context *context, int32_t index, const anysl_point &P, const anysl_normal &N,
              anysl_vector &L, anysl_color &Cl, anysl_color &Ol);

//===-- Questions to light shaders ------------------------------------------------------------===//

/// The service `light_value`, with what is sent. It stays a call and has no wide form: such
/// questions are rare, and most are about what is the same for every point.
[[gnu::noinline]] bool askLightValue(const AnyslShadeArgs *args, uint32_t point, uint32_t light,
                                     double px, double py, double pz, double nx, double ny,
                                     double nz, const char *sent, const anysl_float *numbers,
                                     uint32_t numberCount, const anysl_string *texts,
                                     uint32_t textCount, const char *name, uint32_t type,
                                     uint32_t arrayLength, uint32_t element, AnyslCell *value);

/// The service `light_sent`, likewise.
[[gnu::noinline]] void askLightSent(const AnyslShadeArgs *args, uint32_t point, uint32_t light,
                                    double px, double py, double pz, double nx, double ny,
                                    double nz, const char *sent, const anysl_float *numbers,
                                    uint32_t numberCount, const anysl_string *texts,
                                    uint32_t textCount, double *result);

/// Whether a light shader's parameter is there and not 0. The cell is a slot of this function's
/// own, so that shaders, which all ask for flags in diffuse() and specular(), need none.
[[gnu::noinline]] bool askLightFlag(const AnyslShadeArgs *args, uint32_t point, uint32_t light,
                                    double px, double py, double pz, double nx, double ny,
                                    double nz, const char *name);

/// A flag of a light: fixed, or what its shader computes.
inline bool lightFlag(anysl_context *context, int32_t index, const anysl_point *P,
                      const anysl_normal *N, uint32_t flag, const char *name) {
  uint32_t flags = Light(context, index).flags();
  if (sceneLacks(ANYSL_ASSUMES_NO_LIGHT_SHADERS) || !(flags & ANYSL_LIGHT_COMPUTES_FLAGS))
    return flags & flag;
  return askLightFlag(context->args, context->point, uint32_t(index), double(numberOf(P->x)),
                      double(numberOf(P->y)), double(numberOf(P->z)), double(numberOf(N->x)),
                      double(numberOf(N->y)), double(numberOf(N->z)), name);
}

//===-- Categories ----------------------------------------------------------------------------===//

/// Whether two comma-separated lists, which may be null, have a name in common. `const` says that
/// it is the same for the whole batch, as for spaceMatrixRow(), so it may be called unasked.
[[gnu::const, gnu::noinline]] bool haveCommonName(const char *a, const char *b);

//===-- Helpers -------------------------------------------------------------------------------===//

/// Where the shadow ray of a distant light ends: far outside a scene, and near enough that the
/// square of its length is a float.
inline constexpr double distantLightDistance = 1e12;

inline anysl_vector vectorFrom(const float (&a)[3]) {
  return {anysl_float(a[0]), anysl_float(a[1]), anysl_float(a[2])};
}

inline anysl_color colorFrom(const float (&a)[3]) {
  return {anysl_float(a[0]), anysl_float(a[1]), anysl_float(a[2])};
}

/// 3t^2 - 2t^3 between two edges, and a step where they coincide.
inline anysl_float smoothEdge(const anysl_float &low, const anysl_float &high,
                              const anysl_float &x) {
  anysl_float t = divide(x - low, high - low);
  t = select(t < 0, anysl_float(0), select(t > 1, anysl_float(1), t));
  return select(x < low, anysl_float(0), select(x >= high, anysl_float(1), t * t * (3 - 2 * t)));
}

} // namespace anysl

//===-- Operators -----------------------------------------------------------------------------===//

void anysl_ambient(anysl_color *result, anysl_context *context, const anysl_point *P,
                   const anysl_normal *N) {
  using namespace anysl;
  anysl_color sum =
      colorFrom(anysl_scene_ambient_known ? anysl_scene_ambient : context->args->ambient);
  uint32_t count = sceneLacks(ANYSL_ASSUMES_NO_LIGHT_SHADERS) ? 0 : lightCount(context);
  for (uint32_t i = 0; i < count; ++i) {
    Light light(context, int32_t(i));
    if (!(light.flags() & ANYSL_LIGHT_AMBIENT))
      continue;
    anysl_vector L;
    anysl_color Cl, Ol;
    askLight(context, int32_t(i), *P, *N, L, Cl, Ol);
    Cl = Cl * colorFrom(light.color());
    sum = {sum.r + Cl.r, sum.g + Cl.g, sum.b + Cl.b};
  }
  *result = sum;
}

int32_t anysl_light_count(anysl_context *context) { return int32_t(anysl::lightCount(context)); }

bool anysl_light_is_nondiffuse(anysl_context *context, int32_t index, const anysl_point *P,
                               const anysl_normal *N) {
  return anysl::lightFlag(context, index, P, N, ANYSL_LIGHT_NONDIFFUSE, "__nondiffuse");
}

bool anysl_light_is_nonspecular(anysl_context *context, int32_t index, const anysl_point *P,
                                const anysl_normal *N) {
  return anysl::lightFlag(context, index, P, N, ANYSL_LIGHT_NONSPECULAR, "__nonspecular");
}

bool anysl_light_in_category(anysl_context *context, int32_t index, const anysl_string *wanted) {
  const char *text = *wanted;
  if (!text || !*text)
    return true;
  bool isNegative = *text == '-';
  const char *categories = anysl::Light(context, index).category();
  return anysl::haveCommonName(categories, text + isNegative) != isNegative;
}

namespace anysl {

/// Whether the scene may have lights of a standard kind.
inline bool mayShine(AnyslLightKind kind) {
  switch (kind) {
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence)                                      \
  case ANYSL_LIGHT_##name:                                                                         \
    return !sceneLacks(ANYSL_ASSUMES_##absence);
#include <anysl/LightKinds.def>
  default:
    return true;
  }
}

/// Whether a light of a standard kind is of this one. Nobody looks where the scene has no others.
inline bool isOfKind(const Light &light, AnyslLightKind kind) {
  int kinds = 0;
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence) kinds += mayShine(ANYSL_LIGHT_##name);
#include <anysl/LightKinds.def>
  return mayShine(kind) && (kinds == 1 || light.kind() == uint32_t(kind));
}

/// A light of a standard kind.
inline bool sampleStandard(const Light &light, const anysl_point &P, anysl_vector &L,
                           anysl_color &Cl) {
  anysl_vector direction = vectorFrom(light.direction());
  anysl_vector toLight = vectorFrom(light.from()) - P;
  anysl_float strength(1);
  bool reaches = true;
  if (isOfKind(light, ANYSL_LIGHT_DISTANT)) {
    toLight = -direction;
  } else if (isOfKind(light, ANYSL_LIGHT_POINT)) {
    strength = divide(anysl_float(1), dot(toLight, toLight));
  } else if (isOfKind(light, ANYSL_LIGHT_SPOT)) {
    anysl_float length = lengthOf(toLight.x, toLight.y, toLight.z);
    anysl_float cosine = divide(-dot(toLight, direction), length);
    reaches = cosine > light.cosOuter();
    strength = divide(power(cosine, anysl_float(light.beam())), dot(toLight, toLight)) *
               smoothEdge(anysl_float(light.cosOuter()), anysl_float(light.cosInner()), cosine);
  } else {
    reaches = false;
  }
  anysl_float zero(0);
  anysl_color color = colorFrom(light.color()) * strength;
  L = toLight;
  Cl = {select(reaches, color.r, zero), select(reaches, color.g, zero),
        select(reaches, color.b, zero)};
  return reaches;
}

/// Whether light arrives along what a light shader made of L.
inline bool arrives(const anysl_vector &L) {
  return int(numberOf(L.x) != 0) | int(numberOf(L.y) != 0) | int(numberOf(L.z) != 0);
}

} // namespace anysl

bool anysl_light_sample(anysl_context *context, int32_t index, const anysl_point *P,
                        const anysl_normal *N, anysl_vector *L, anysl_color *Cl, anysl_color *Ol) {
  using namespace anysl;
  const Light light(context, index);
  anysl_float zero(0), one(1);
  *Ol = {one, one, one};
  if (!light.isShader())
    return sampleStandard(light, *P, *L, *Cl);
  *L = {zero, zero, zero};
  *Cl = {zero, zero, zero};
  if (light.flags() & ANYSL_LIGHT_AMBIENT)
    return false;
  askLight(context, index, *P, *N, *L, *Cl, *Ol);
  *Cl = *Cl * colorFrom(light.color());
  return arrives(*L);
}

bool anysl_light_sample_sent(anysl_context *context, int32_t index, const anysl_point *P,
                             const anysl_normal *N, const anysl_string *sent, anysl_float *numbers,
                             uint32_t numberCount, anysl_string *texts, uint32_t textCount,
                             anysl_vector *L, anysl_color *Cl, anysl_color *Ol) {
  using namespace anysl;
  const Light light(context, index);
  // A renderer that runs its lights itself need not say what they are.
  bool takesValues = light.kind() == ANYSL_LIGHT_SHADER || light.shader();
  if (!takesValues || light.flags() & ANYSL_LIGHT_AMBIENT)
    return anysl_light_sample(context, index, P, N, L, Cl, Ol);
  double result[9];
  askLightSent(context->args, context->point, uint32_t(index), double(numberOf(P->x)),
               double(numberOf(P->y)), double(numberOf(P->z)), double(numberOf(N->x)),
               double(numberOf(N->y)), double(numberOf(N->z)), *sent, numbers, numberCount, texts,
               textCount, result);
  *L = {anysl_float(result[0]), anysl_float(result[1]), anysl_float(result[2])};
  *Cl = {anysl_float(result[3]), anysl_float(result[4]), anysl_float(result[5])};
  *Ol = {anysl_float(result[6]), anysl_float(result[7]), anysl_float(result[8])};
  if (light.isShader())
    *Cl = *Cl * colorFrom(light.color());
  return arrives(*L);
}

bool anysl_light_handle(anysl_string *result, anysl_context *context, int32_t index) {
  const char *handle = anysl::Light(context, index).handle();
  *result = handle ? handle : "";
  return **result != 0;
}

void anysl_light_end(anysl_point *result, anysl_context *context, int32_t index,
                     const anysl_point *P, const anysl_vector *L) {
  using namespace anysl;
  const Light light(context, index);
  *result = vectorFrom(light.from());
  if (light.isShader()) {
    anysl_float far = divide(anysl_float(distantLightDistance), lengthOf(L->x, L->y, L->z));
    *result = *P + *L * (light.flags() & ANYSL_LIGHT_FAR ? far : anysl_float(1));
  } else if (isOfKind(light, ANYSL_LIGHT_DISTANT)) {
    *result = *P - vectorFrom(light.direction()) * anysl_float(distantLightDistance);
  }
}

/// An operator of its own, so that only those points send a ray which the light reaches and which
/// face it.
void anysl_light_shadow(anysl_context *context, int32_t index, const anysl_point *P,
                        const anysl_vector *L, anysl_color *Cl) {
  using namespace anysl;
  if (!(Light(context, index).flags() & ANYSL_LIGHT_CASTS_SHADOW))
    return;
  anysl_point end;
  anysl_light_end(&end, context, index, P, L);
  anysl_color passing;
  anysl_transmission(&passing, context, P, &end);
  *Cl = *Cl * passing;
}

//===-- Light shaders that are linked in ------------------------------------------------------===//

namespace anysl {

inline anysl_float lightCell(const anysl_context *context, int32_t light, int32_t cell) {
  return anysl_float(Light(context, light).params()[cell].number);
}

} // namespace anysl

void anysl_linked_light_float(anysl_float *result, anysl_context *context, int32_t light,
                              int32_t cell) {
  *result = anysl::lightCell(context, light, cell);
}

void anysl_linked_light_color(anysl_color *result, anysl_context *context, int32_t light,
                              int32_t cell) {
  *result = {anysl::lightCell(context, light, cell), anysl::lightCell(context, light, cell + 1),
             anysl::lightCell(context, light, cell + 2)};
}

void anysl_linked_light_vector(anysl_vector *result, anysl_context *context, int32_t light,
                               int32_t cell) {
  *result = {anysl::lightCell(context, light, cell), anysl::lightCell(context, light, cell + 1),
             anysl::lightCell(context, light, cell + 2)};
}

void anysl_linked_light_matrix(anysl_matrix *result, anysl_context *context, int32_t light,
                               int32_t cell) {
  anysl::repeat<16>([&](auto k) {
    result->m[k / 4][k % 4] = anysl::lightCell(context, light, cell + int32_t(k));
  });
}

void anysl_linked_light_string(anysl_string *result, anysl_context *context, int32_t light,
                               int32_t cell) {
  *result = anysl::Light(context, light).params()[cell].string;
}

void anysl_linked_light_from(anysl_point *result, anysl_context *context, int32_t light) {
  *result = anysl::vectorFrom(anysl::Light(context, light).from());
}

void anysl_linked_light_direction(anysl_vector *result, anysl_context *context, int32_t light) {
  *result = anysl::vectorFrom(anysl::Light(context, light).direction());
}

bool anysl_linked_light_arrives(anysl_context *context, int32_t light, anysl_vector *L,
                                anysl_color *Cl) {
  using namespace anysl;
  anysl_float zero(0);
  *L = anysl_vector{zero, zero, zero} - *L;
  *Cl = *Cl * colorFrom(Light(context, light).color());
  return arrives(*L);
}

//===-- Parameters of light shaders -----------------------------------------------------------===//

/// What the five operators take before the variable.
#define ANYSL_LIGHT_VALUE_PARAMETERS                                                               \
  anysl_context *context, int32_t index, const anysl_point *P, const anysl_normal *N,              \
      const anysl_string *sent, anysl_float *numbers, uint32_t numberCount, anysl_string *texts,   \
      uint32_t textCount, const anysl_string *name, uint32_t arrayLength, uint32_t element
#define ANYSL_LIGHT_VALUE_ARGUMENTS                                                                \
  context, index, P, N, sent, numbers, numberCount, texts, textCount, name, arrayLength, element

namespace anysl {

inline bool lightValue(ANYSL_LIGHT_VALUE_PARAMETERS, uint32_t type, AnyslCell *cells) {
  return askLightValue(context->args, context->point, uint32_t(index), double(numberOf(P->x)),
                       double(numberOf(P->y)), double(numberOf(P->z)), double(numberOf(N->x)),
                       double(numberOf(N->y)), double(numberOf(N->z)), *sent, numbers, numberCount,
                       texts, textCount, *name, type, arrayLength, element, cells);
}

} // namespace anysl

bool anysl_light_float(ANYSL_LIGHT_VALUE_PARAMETERS, anysl_float *value) {
  AnyslCell cells[1];
  bool known = anysl::lightValue(ANYSL_LIGHT_VALUE_ARGUMENTS, ANYSL_FLOAT, cells);
  if (known)
    *value = anysl_float(cells[0].number);
  return known;
}

bool anysl_light_color(ANYSL_LIGHT_VALUE_PARAMETERS, anysl_color *value) {
  AnyslCell cells[3];
  bool known = anysl::lightValue(ANYSL_LIGHT_VALUE_ARGUMENTS, ANYSL_COLOR, cells);
  if (known)
    *value = {anysl_float(cells[0].number), anysl_float(cells[1].number),
              anysl_float(cells[2].number)};
  return known;
}

bool anysl_light_vector(ANYSL_LIGHT_VALUE_PARAMETERS, anysl_vector *value) {
  AnyslCell cells[3];
  bool known = anysl::lightValue(ANYSL_LIGHT_VALUE_ARGUMENTS, ANYSL_VECTOR, cells);
  if (known)
    *value = {anysl_float(cells[0].number), anysl_float(cells[1].number),
              anysl_float(cells[2].number)};
  return known;
}

bool anysl_light_matrix(ANYSL_LIGHT_VALUE_PARAMETERS, anysl_matrix *value) {
  AnyslCell cells[16];
  bool known = anysl::lightValue(ANYSL_LIGHT_VALUE_ARGUMENTS, ANYSL_MATRIX, cells);
  if (known)
    anysl::repeat<16>([&](auto k) { value->m[k / 4][k % 4] = anysl_float(cells[int(k)].number); });
  return known;
}

bool anysl_light_string(ANYSL_LIGHT_VALUE_PARAMETERS, anysl_string *value) {
  AnyslCell cells[1];
  bool known = anysl::lightValue(ANYSL_LIGHT_VALUE_ARGUMENTS, ANYSL_STRING, cells);
  if (known)
    *value = cells[0].string;
  return known;
}

#undef ANYSL_LIGHT_VALUE_PARAMETERS
#undef ANYSL_LIGHT_VALUE_ARGUMENTS

bool anysl::askLightValue(const AnyslShadeArgs *args, uint32_t point, uint32_t light, double px,
                          double py, double pz, double nx, double ny, double nz, const char *sent,
                          const anysl_float *numbers, uint32_t numberCount,
                          const anysl_string *texts, uint32_t textCount, const char *name,
                          uint32_t type, uint32_t arrayLength, uint32_t element, AnyslCell *value) {
  auto ask = args->services->light_value;
  if (!ask || !name)
    return false;
  double P[3] = {px, py, pz}, N[3] = {nx, ny, nz};
  AnyslQuery query = {ANYSL_QUERY_lightsource, type, arrayLength, element, light, 0, name, ""};
  return withMessage(sent, numbers, numberCount, texts, textCount, [&](AnyslMessage &message) {
    const AnyslMessage *given = *message.what ? &message : nullptr;
    return ask(args->renderer, args, point, light, P, N, given, &query, value) != 0;
  });
}

void anysl::askLightSent(const AnyslShadeArgs *args, uint32_t point, uint32_t light, double px,
                         double py, double pz, double nx, double ny, double nz, const char *sent,
                         const anysl_float *numbers, uint32_t numberCount,
                         const anysl_string *texts, uint32_t textCount, double *result) {
  for (int i = 0; i < 9; ++i)
    result[i] = i < 6 ? 0 : 1;
  auto ask = args->services->light_sent;
  if (!ask)
    return;
  double P[3] = {px, py, pz}, N[3] = {nx, ny, nz};
  withMessage(sent, numbers, numberCount, texts, textCount, [&](AnyslMessage &message) {
    ask(args->renderer, args, point, light, P, N, &message, result);
  });
}

bool anysl::askLightFlag(const AnyslShadeArgs *args, uint32_t point, uint32_t light, double px,
                         double py, double pz, double nx, double ny, double nz, const char *name) {
  AnyslCell value;
  return askLightValue(args, point, light, px, py, pz, nx, ny, nz, "", nullptr, 0, nullptr, 0, name,
                       ANYSL_FLOAT, 0, 0, &value) &&
         value.number != 0;
}

bool anysl::haveCommonName(const char *a, const char *b) {
  if (!a || !b)
    return false;
  auto endOf = [](const char *name) {
    while (*name && *name != ',')
      ++name;
    return name;
  };
  for (const char *i = a;; ++i) {
    const char *iEnd = endOf(i);
    for (const char *k = b;; ++k) {
      const char *kEnd = endOf(k);
      const char *p = i, *q = k;
      while (p != iEnd && q != kEnd && *p == *q)
        ++p, ++q;
      if (p == iEnd && q == kEnd && i != iEnd)
        return true;
      k = kEnd;
      if (!*k)
        break;
    }
    i = iEnd;
    if (!*i)
      return false;
  }
}

#endif // ANYSL_STANDARD_LIGHTS_H
