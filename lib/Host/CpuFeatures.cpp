//===-- lib/Host/CpuFeatures.cpp - whether the processor has what code needs ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <algorithm>
#include <iterator>
#include <string_view>

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>

namespace {

enum Register { Eax, Ebx, Ecx, Edx };

// Bits of XCR0: the register state that the operating system saves for us.
enum State : uint64_t { None = 0, Ymm = 0x6, Zmm = 0xe6, Tile = 0x60000 };

struct Feature {
  std::string_view name;
  uint32_t leaf, subleaf;
  Register in;
  unsigned bit;
  uint64_t state;
};
constexpr Feature features[] = {
#define CPU_FEATURE(name, leaf, subleaf, in, bit, state) {name, leaf, subleaf, in, bit, state},
#include "lib/Host/CpuFeatures.def"
};

/// What CPUID says, asked once: under a hypervisor every question takes microseconds.
class Processor {
public:
  Processor() {
    for (const Feature &feature : features)
      if (!find(feature))
        ask(feature);
    constexpr unsigned osxsave = 1u << 27;
    if (!(leaves[0].registers[Ecx] & osxsave)) // the table begins with leaf 1
      return;
    // By hand, since the intrinsic may only be used in code compiled for processors that have it.
    uint32_t low, high;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    savedState = uint64_t(high) << 32 | low;
  }

  bool has(std::string_view name) const {
    for (const Feature &feature : features)
      if (feature.name == name)
        return (find(feature)->registers[feature.in] >> feature.bit & 1) &&
               (savedState & feature.state) == feature.state;
    return false;
  }

private:
  struct Leaf {
    uint32_t leaf, subleaf;
    unsigned registers[4];
  };

  const Leaf *find(const Feature &feature) const {
    for (unsigned i = 0; i < count; ++i)
      if (leaves[i].leaf == feature.leaf && leaves[i].subleaf == feature.subleaf)
        return &leaves[i];
    return nullptr;
  }

  void ask(const Feature &feature) {
    Leaf &added = leaves[count++];
    added = {feature.leaf, feature.subleaf, {}};
    unsigned *r = added.registers;
    if (!__get_cpuid_count(feature.leaf, feature.subleaf, &r[Eax], &r[Ebx], &r[Ecx], &r[Edx]))
      std::fill_n(r, 4, 0);
  }

  Leaf leaves[std::size(features)];
  unsigned count = 0;
  uint64_t savedState = 0;
};

bool has(std::string_view name) {
  static const Processor processor;
  return processor.has(name);
}

} // namespace

#else
static bool has(std::string_view) { return false; }
#endif

std::string anysl::host::missingCpuFeatures(const char *list) {
  std::string missing;
  std::string_view rest = list ? list : "";
  while (!rest.empty()) {
    std::string_view name = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), name.size() + 1));
    // LLVM writes +name for needed and -name for avoided.
    if (!name.empty() && name[0] == '+')
      name.remove_prefix(1);
    if (name.empty() || name[0] == '-' || has(name))
      continue;
    missing += missing.empty() ? "" : ", ";
    missing += name;
  }
  return missing;
}
