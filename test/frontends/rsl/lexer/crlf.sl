// A file with CR-LF line ends; the message counts lines as an editor does.
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s
surface s() {
  Ci = nothing;
}
// CHECK: crlf.sl:4:8: error: unknown variable 'nothing'
