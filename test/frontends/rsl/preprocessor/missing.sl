// A missing file is reported, and not all that it would have defined.
// RUN: rslc -verify -fsyntax-only %s
// RUN: not rslc -fsyntax-only %s -I 1 -I 2 -I 1 -I 3 -I 4 -I 5 -I 6 -I 7 2>&1 | FileCheck %s
// CHECK: cannot find 'nowhere.h' (searched in 1, 2, 3, 4, 5 and in 2 more folders)

#include "missing.h"       // expected-error {{cannot find 'missing.h' (searched in }}
#include "/dev/zero"       // expected-error {{cannot read '/dev/zero': it is a device}}
#include <nowhere.h>       // expected-error {{cannot find 'nowhere.h' (no -I folder is given)}}

surface missing(DEFAULTS) { Ci = f(1); }
