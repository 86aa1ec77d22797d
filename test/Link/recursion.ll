; A function of a shader's own may not call itself, by whatever way: there is no stack where shaders run.
;
; RUN: not anysl-link %s -o %t.so 2>&1 | FileCheck %s
; CHECK: rec.sl:4:7: error: recursion, which shaders cannot have: even → odd → even
; RUN: not ls %t.so

define void @rec(ptr %ctx) !dbg !10 {
  call void @even(), !dbg !11
  ret void
}

define void @rec.init(ptr %ctx) !dbg !12 {
  ret void
}

define internal void @even() !dbg !13 !anysl.signature !9 {
  call void @odd(), !dbg !14
  ret void
}

define internal void @odd() !dbg !15 !anysl.signature !9 {
  call void @even(), !dbg !16
  ret void
}

!anysl.stc = !{!0}
!anysl.shaders = !{!1}
!llvm.dbg.cu = !{!5}
!llvm.module.flags = !{!7}
!0 = !{i32 1, !"by hand"}
!1 = !{!"rec", !"surface", ptr @rec, ptr @rec.init, !9, !9}
!5 = distinct !DICompileUnit(language: DW_LANG_C, file: !6, isOptimized: true, runtimeVersion: 0, emissionKind: NoDebug)
!6 = !DIFile(filename: "rec.sl", directory: "")
!7 = !{i32 2, !"Debug Info Version", i32 3}
!8 = !DISubroutineType(types: !9)
!9 = !{}
!10 = distinct !DISubprogram(name: "rec", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!11 = !DILocation(line: 2, column: 3, scope: !10)
!12 = distinct !DISubprogram(name: "rec.init", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!13 = distinct !DISubprogram(name: "even", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!14 = !DILocation(line: 3, column: 3, scope: !13)
!15 = distinct !DISubprogram(name: "odd", file: !6, line: 1, type: !8, spFlags: DISPFlagDefinition, unit: !5)
!16 = !DILocation(line: 4, column: 7, scope: !15)
