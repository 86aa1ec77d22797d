/* A surface that answers NaN left of the picture's middle and 1/2 right of it, as one may be linked
   by hand. */
#include <anysl/abi.h>

static void shade(const AnyslShadeArgs *args, uint32_t first, uint32_t last) {
  float *const *globals = (float *const *)args->globals;
  for (uint32_t i = first; i < last; ++i)
    for (int k = 0; k < 3; ++k) {
      float x = globals[ANYSL_COMPONENT_P][i];
      globals[ANYSL_COMPONENT_Ci + k][i] = x < 0 ? __builtin_nanf("") : 0.5f;
      globals[ANYSL_COMPONENT_Oi + k][i] = 1;
    }
}

#define BIT(global) ((uint64_t)1 << ANYSL_##global)

static const AnyslEntryInfo entries[] = {{1, shade}, {4, shade}, {8, shade}, {16, shade}};
static const AnyslShaderInfo shaders[] = {
    {"bad", ANYSL_SURFACE, 0, 0, 0, 4, entries, BIT(P), BIT(Ci) | BIT(Oi), 0, 0, 0}};
const AnyslLibraryInfo anysl_library = {ANYSL_MAGIC,
                                        ANYSL_ABI_VERSION,
                                        sizeof(AnyslLibraryInfo),
                                        ANYSL_LAYOUT_SOA,
                                        ANYSL_REAL_FLOAT,
                                        ANYSL_GLOBAL_COUNT,
                                        ANYSL_COMPONENT_COUNT,
                                        sizeof(AnyslShadeArgs),
                                        sizeof(AnyslServices),
                                        1,
                                        shaders,
                                        "by hand",
                                        "packet",
                                        "float",
                                        "none",
                                        "x86-64",
                                        ""};
