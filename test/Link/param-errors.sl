/* RUN: rslc %s -o %t.stc.bc
RUN: rm -f %t.so
RUN: not anysl-link %t.stc.bc -o %t.so --param rougness=1 2>&1 | FileCheck %s --check-prefix NAME
RUN: not anysl-link %t.stc.bc -o %t.so --param shinny.roughness=1 2>&1 | FileCheck %s --check-prefix SHADER
RUN: not anysl-link %t.stc.bc -o %t.so --param roughness=smooth 2>&1 | FileCheck %s --check-prefix NUMBER
RUN: not anysl-link %t.stc.bc -o %t.so --param tint=1,2 2>&1 | FileCheck %s --check-prefix COUNT
RUN: not anysl-link %t.stc.bc -o %t.so --param roughness 2>&1 | FileCheck %s --check-prefix FORM
RUN: not anysl-link %t.stc.bc -o %t.so --param roughness=1 --param shiny.roughness=2 2>&1 | FileCheck %s --check-prefix TWICE
RUN: not anysl-link %t.stc.bc -o %t.so --param result=2 2>&1 | FileCheck %s --check-prefix OUTPUT
RUN: not ls %t.so

NAME: anysl-link: error: --param rougness=1: there is no parameter 'rougness'; did you mean 'roughness'?
SHADER: error: --param shinny.roughness=1: there is no shader 'shinny'; did you mean 'shiny'?
NUMBER: error: --param shiny.roughness: 'smooth' is no number
COUNT: error: --param shiny.tint: expected 3 numbers for a color, got 2
FORM: error: --param roughness: expected NAME=value or SHADER.NAME=value
TWICE: error: --param shiny.roughness is given twice
OUTPUT: error: --param result: an output parameter cannot be a constant
*/

surface shiny(float roughness = 0.1; color tint = 1; output varying float result = 0) {
  result = roughness;
  Ci = tint;
}
