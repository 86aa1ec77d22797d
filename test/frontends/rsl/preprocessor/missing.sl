// A missing file is reported, and not all that it would have defined.
// RUN: rslc -verify -fsyntax-only %s

#include "missing.h"       // expected-error {{cannot find 'missing.h' (searched in }}
#include <nowhere.h>       // expected-error {{cannot find 'nowhere.h' (no -I folder is given)}}

surface missing(DEFAULTS) { Ci = f(1); }
