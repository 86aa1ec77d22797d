/* A shader library exports its descriptor and nothing else, runs nothing when it is loaded, needs no other
   library, and is the same file each time.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so
RUN: llvm-nm -D --defined-only --format=just-symbols %t.so | FileCheck %s --check-prefix SYMBOLS
RUN: llvm-readelf -d %t.so | FileCheck %s --check-prefix DYNAMIC
RUN: llvm-readelf -S %t.so | FileCheck %s --check-prefix SECTIONS
RUN: ldd %t.so | FileCheck %s --check-prefix LDD
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.again.so
RUN: cmp %t.so %t.again.so

Where the front end asks for line tables, they are there, and still one dynamic symbol.
RUN: rslc -S %s -o - | sed s/NoDebug/LineTablesOnly/ > %t.g.ll
RUN: anysl-link %t.g.ll --width 1,8 -o %t.g.so
RUN: llvm-readelf -S %t.g.so | grep debug_line
RUN: llvm-nm -D --defined-only --format=just-symbols %t.g.so | FileCheck %s --check-prefix SYMBOLS
RUN: not anysl-link %t.stc.bc --width 1 --emit so -o - 2>&1 | FileCheck %s --check-prefix STDOUT

SYMBOLS: anysl_library
SYMBOLS-NOT: {{.}}
DYNAMIC-NOT: {{NEEDED|INIT|TEXTREL}}
SECTIONS-NOT: {{init_array|ctors|debug|symtab}}
LDD-NOT: =>
STDOUT: error: a shared library cannot go to standard output
*/

surface patterned() {
  Ci = color noise(10 * P) * pow(abs(sin(20 * u)), 3) * trace(P, reflect(I, N));
}
