//===-- lib/Host/Internal.h - what the parts of the loader share --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The objects behind the handles of <anysl/anysl.h>. Instances and batches share the loaded
// library, so its code stays mapped for as long as any of them can reach it.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_HOST_INTERNAL_H
#define ANYSL_LIB_HOST_INTERNAL_H

#include <anysl/anysl.h>
#include <anysl/demand.h>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace anysl::host {

struct LightCache;

/// Records \p message as the thread's last error. Allocates, so callers are inside guarded().
AnyslStatus fail(AnyslStatus status, const std::string &message);
/// The same without allocating.
AnyslStatus failForMemory();

/// Runs the body of a C function; running out of memory becomes a status like any other.
template <class Body>
AnyslStatus guarded(Body body) {
  try {
    return body();
  } catch (const std::bad_alloc &) {
  } catch (const std::length_error &) {
  }
  return failForMemory();
}

struct LoadedLibrary {
  std::string path;
  const AnyslLibraryInfo *info = nullptr;
  bool inspectOnly = false;
  void *handle = nullptr; ///< of dlopen; null for shaders that are part of the program
  const AnyslDemandInfo *demand = nullptr; ///< what it was linked for; null: any scene

  LoadedLibrary() = default;
  LoadedLibrary(const LoadedLibrary &) = delete;
  LoadedLibrary &operator=(const LoadedLibrary &) = delete;
  ~LoadedLibrary();
};

using LibraryRef = std::shared_ptr<const LoadedLibrary>;

/// Gives services that a renderer does not offer (LightShaders.cpp).
void completeLightServices(AnyslServices &services);

/// Answers a question about a light of a standard kind (LightShaders.cpp).
int standardLightValue(const AnyslLight &light, const AnyslQuery &query, AnyslCell *value,
                       const AnyslMessage *sent = nullptr);
/// What a light of a standard kind gives where values are sent to it: L, Cl and Ol. Where it does
/// not shine, the result stays as it is.
void sampleStandardSent(const AnyslLight &light, const double *P, const AnyslMessage &sent,
                        double *result);

/// Whether everything the descriptor says can be relied upon; fails with a message if not.
AnyslStatus checkDescriptor(const LoadedLibrary &library);

/// What the object of a library says that it was linked for; null: any scene.
const AnyslDemandInfo *findDemand(void *handle);
/// Whether it was linked for a scene that does not look at this output.
bool isDropped(const AnyslDemandInfo &demand, std::string_view output);
/// What a shader of a library could do for any scene.
AnyslSourceInfo sourceOf(const LoadedLibrary &library, const AnyslShaderInfo &shader);
/// A global that the library takes for the same at all points; null: it asks for it, or for none.
const AnyslFixedGlobal *fixedGlobal(const LoadedLibrary &library, int global);
/// Fails if the library lacks what a scene calls for, apart from its lights.
AnyslStatus checkDemand(const LoadedLibrary &library, const AnyslSceneFacts &facts);
/// Fails if other lights are linked into the library than these, or it has none for them.
/// `ambient`: what ambient ones add up to.
AnyslStatus checkLights(const LoadedLibrary &library, const AnyslLight *lights, uint32_t count,
                        const float (&ambient)[3]);

/// What the processor lacks of a comma-separated list of x86 features, in the list's own words;
/// empty if nothing. A name that is not known counts as lacking.
std::string missingCpuFeatures(const char *features);

/// Numbers or texts in a whole parameter, all array elements counted.
uint32_t cellsOf(const AnyslParamInfo &param);

/// The parameter's number, or -1 after recording that there is none.
int findParam(const LoadedLibrary &library, const AnyslShaderInfo &shader, const char *name);

/// "wood.so: shader 'wood': ", how messages about a shader begin.
std::string context(const LoadedLibrary &library, const AnyslShaderInfo &shader);

/// Zero-filled memory aligned to a cache line.
class AlignedBuffer {
public:
  AlignedBuffer() = default;
  explicit AlignedBuffer(size_t bytes);
  char *get() const { return memory.get(); }

private:
  struct Free {
    void operator()(void *memory) const { std::free(memory); }
  };
  std::unique_ptr<char, Free> memory;
};

} // namespace anysl::host

struct AnyslLibrary {
  anysl::host::LibraryRef loaded;
};

struct AnyslInstance {
  anysl::host::LibraryRef library;
  const AnyslShaderInfo *shader;
  AnyslServices services; ///< the renderer's, completed by libanysl's own
  void *renderer;
  std::vector<AnyslCell> cells;
  std::vector<uint8_t> isSet;                      ///< by parameter
  std::vector<std::unique_ptr<std::string>> texts; ///< by cell: texts that the host gave
};

/// Where the values of a global or parameter lie, counted in reals: component c of array element e
/// at point p is base[e * element + c * component + p * point].
struct AnyslView {
  char *base = nullptr;
  size_t element = 0, component = 0, point = 0;
};

struct AnyslBatch {
  anysl::host::LibraryRef library;
  const AnyslShaderInfo *shader;
  uint32_t capacity;
  size_t stride; ///< points from one component array to the next
  uint64_t globals;
  anysl::host::AlignedBuffer globalData;
  std::vector<void *> globalPointers;                   ///< as AnyslShadeArgs::globals wants them
  std::vector<AnyslView> globalViews;                   ///< by global; base null: not there
  std::vector<anysl::host::AlignedBuffer> paramBuffers; ///< by parameter
  std::vector<void *> paramPointers;
  struct Derivatives {
    std::vector<anysl::host::AlignedBuffer> buffers; ///< by parameter
    std::vector<void *> pointers;
  } byU, byV;                      ///< of bound parameters; empty: of none
  std::vector<uint8_t> paramFlags; ///< as AnyslShadeArgs::param_is_set wants them
  std::vector<uint32_t> seeds;
  AnyslShadeArgs args; ///< without what the instance adds
};

#endif
