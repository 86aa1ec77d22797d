// Included files: found beside the file that includes them and in -I folders; messages say how they came in.
// RUN: rslc -S -o - %s -I %S/Inputs | FileCheck %s
// RUN: not rslc %s -I %S/Inputs -DBAD -o %t.bc 2>&1 | FileCheck %s --check-prefix=BAD
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s --check-prefix=MISSING

// BAD: in file included from {{.*}}include.sl:12:
// BAD: {{.*}}outer.h:2:32: error: unknown variable 'undefined'
// MISSING: include.sl:14:10: error: cannot find 'half.h'

#ifdef BAD
// An include inside of an include is looked for beside it.
#include "Inputs/outer.h"
#else
#include <half.h>
#endif

surface include() {
  // CHECK: anysl_div_float
  Ci = half(3);
}
