/* What cannot be written is said, and nothing is left behind.

RUN: rslc %s -o %t.stc.bc
RUN: not anysl-link %t.stc.bc --width 1 -o %t.none/plain.so 2>&1 | FileCheck %s --check-prefix FOLDER
RUN: rm -rf %t.dir && mkdir %t.dir && mkdir %t.dir/plain.so
RUN: not anysl-link %t.stc.bc --width 1 -o %t.dir/plain.so 2>&1 | FileCheck %s --check-prefix TAKEN
RUN: ls %t.dir | FileCheck %s --check-prefix LEFT
RUN: not anysl-link %t.stc.bc --width 1 --emit ll -o /dev/full 2>&1 | FileCheck %s --check-prefix FULL

An older file survives a link that fails.
RUN: echo old > %t.old.so
RUN: not anysl-link %t.stc.bc --width 1 --runtime none -o %t.old.so
RUN: grep old %t.old.so

FOLDER: plain.so: error: cannot write the file: No such file or directory
TAKEN: plain.so: error: cannot write the file
LEFT: plain.so
LEFT-NOT: tmp
FULL: /dev/full: error: cannot write the file: No space left on device
*/

surface plain() {
  Ci = Cs;
}
