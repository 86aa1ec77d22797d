// Macros that multiply without bounds end in a message, not in exhausted memory.
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s
// CHECK: error: macros expand to more than 4194304 words
// CHECK: {{^}}1 error generated.
#define A 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1
#define B A + A + A + A + A + A + A + A + A + A
#define C B + B + B + B + B + B + B + B + B + B
#define D C + C + C + C + C + C + C + C + C + C
#define E D + D + D + D + D + D + D + D + D + D
#define F E + E + E + E + E + E + E + E + E + E
#define G F + F + F + F + F + F + F + F + F + F
#define H G + G + G + G + G + G + G + G + G + G
surface growth() { Ci = H; }
