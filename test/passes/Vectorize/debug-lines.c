// Variants keep the lines of their source, and remarks name them.
// RUN: clang -g -O1 -fopenmp-simd -S -emit-llvm %s -o - | opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>,verify' -pass-remarks=anysl-vectorize -pass-remarks-missed=anysl-vectorize -pass-remarks-analysis=anysl-vectorize -S -o %t.ll 2>&1 | FileCheck --check-prefix=REMARK %s
// RUN: FileCheck %s < %t.ll
extern float opaque(float);

// CHECK: define {{.*}} @_ZGVdN8v_lines({{.*}} !dbg [[OWN:![0-9]+]]
// CHECK: [[OWN]] = distinct !DISubprogram(name: "lines"
// REMARK-DAG: debug-lines.c:[[@LINE+2]]:{{.*}}: widened to 8 lanes as _ZGVdN8v_lines
#pragma omp declare simd notinbranch
float lines(float x) {
  // REMARK-DAG: debug-lines.c:[[@LINE+1]]:{{[0-9]+}}: lanes may leave this loop at different times
  while (x > 1)
    // REMARK-DAG: debug-lines.c:[[@LINE+1]]:{{[0-9]+}}: calls opaque once per active lane
    x = opaque(x) * 0.5f;
  return x;
}

#pragma omp declare simd notinbranch uniform(table)
float look(const float *table, unsigned k) {
  // REMARK-DAG: debug-lines.c:[[@LINE+1]]:{{[0-9]+}}: loads from an unrelated address in each lane
  return table[k & 255];
}
