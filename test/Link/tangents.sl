/* With --tangents displacement shaders store how P changes, and need numbers with derivatives for it. Those that move P by what carries
   none, such as shadow maps, do not; nor do surfaces.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so --report %t.json && FileCheck %s --check-prefix PLAIN < %t.json
RUN: anysl-link %t.stc.bc --width 1,8 --tangents -o %t.so --report %t.json && FileCheck %s --check-prefix TANGENTS < %t.json
RUN: anysl-info %t.so | FileCheck %s --check-prefix INFO
RUN: rslc -DMOVED='float texture("wave.tx", s, t)' %s -o %t.picture.stc.bc
RUN: anysl-link %t.picture.stc.bc --tangents -o %t.so --report %t.json && FileCheck %s --check-prefix TANGENTS < %t.json
RUN: rslc -DMOVED='shadow("wave.tx", P)' %s -o %t.shadow.stc.bc
RUN: anysl-link %t.shadow.stc.bc --tangents -o %t.so --report %t.json && FileCheck %s --check-prefix SHADOW < %t.json
RUN: rslc -DSURFACE %s -o %t.surface.stc.bc
RUN: anysl-link %t.surface.stc.bc --tangents -o %t.so --report %t.json && FileCheck %s --check-prefix PLAIN < %t.json
RUN: anysl-link %t.stc.bc --tangents --dump-after tangents | FileCheck %s --check-prefix DUMP

PLAIN: "real": "float"
PLAIN: "globalsWritten": [
PLAIN-NOT: "dPdu"
PLAIN: ]
TANGENTS: "real": "dual"
TANGENTS: "globalsWritten": [
TANGENTS-DAG: "P"
TANGENTS-DAG: "dPdu"
TANGENTS-DAG: "dPdv"
TANGENTS: ]
INFO: writes {{.*}}dPdu dPdv
SHADOW: "globalsWritten": [
SHADOW-NOT: "dPdu"
SHADOW: ]
DUMP: call void @anysl_Du_vector(ptr [[SLOT:%[^,]*]], ptr %P)
DUMP: call void @anysl_store_global_vector(ptr %ctx, i32 12, ptr [[SLOT]])
DUMP: call void @anysl_store_global_vector(ptr %ctx, i32 0, ptr %P)
*/
#ifdef SURFACE
surface moved() { P += N; }
#else
displacement moved() {
#ifdef MOVED
  P += MOVED * N;
#else
  P += s * N;
#endif
}
#endif
