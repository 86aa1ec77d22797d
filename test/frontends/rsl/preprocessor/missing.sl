// A missing file is reported, and not all that it would have defined.
// RUN: rslc -verify -fsyntax-only %s

#include "missing.h"       // expected-error {{cannot find 'missing.h' (searched in }}
#include "/dev/zero"       // expected-error {{cannot read '/dev/zero': it is a device}}
#include <nowhere.h>       // expected-error {{cannot find 'nowhere.h' (no -I folder is given)}}

surface missing(DEFAULTS) { Ci = f(1); }
