/* The suffix of -o says what is written, --emit overrules it.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1 -o %t.ll
RUN: FileCheck %s --check-prefix LL < %t.ll
RUN: anysl-link %t.stc.bc --width 1 -o %t.bc
RUN: llvm-dis %t.bc -o - | FileCheck %s --check-prefix LL
RUN: anysl-link %t.stc.bc --width 1 -o %t.s
RUN: FileCheck %s --check-prefix ASM < %t.s
RUN: anysl-link %t.stc.bc --width 1 -o %t.o
RUN: llvm-readelf -h %t.o | FileCheck %s --check-prefix OBJ
RUN: anysl-link %t.stc.bc --width 1 -o %t.so
RUN: llvm-readelf -h %t.so | FileCheck %s --check-prefix SO
RUN: anysl-link %t.stc.bc --width 1 --emit asm -o - | FileCheck %s --check-prefix ASM
RUN: anysl-link %t.stc.bc --width 1 --emit ll -o %t.so
RUN: FileCheck %s --check-prefix LL < %t.so

Without -o the name is the input's, in the current folder.
RUN: rm -rf %t.dir && mkdir %t.dir && cp %t.stc.bc %t.dir/plain.stc.bc
RUN: cd %t.dir && anysl-link plain.stc.bc --width 1 && anysl-link plain.stc.bc --width 1 --emit obj
RUN: ls %t.dir | FileCheck %s --check-prefix NAMES

Other processors and systems of the same kind can be asked for.
RUN: anysl-link %t.stc.bc --width 8 --mcpu haswell -o %t.s
RUN: not grep zmm %t.s
RUN: anysl-link %t.stc.bc --width 4 --mcpu x86-64 -o %t.s
RUN: not grep ymm %t.s

LL: @anysl_library = constant
LL: define internal void @plain.w1(
ASM: plain.w1:
ASM: .globl anysl_library
OBJ: Type: REL (Relocatable file)
SO: Type: DYN (Shared object file)
NAMES: plain.o
NAMES-NEXT: plain.so
NAMES-NEXT: plain.stc.bc
*/

surface plain() {
  Ci = Cs;
}
