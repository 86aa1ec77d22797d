// TESTS: radians degrees sign round log_base step smoothstep filterstep
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x2
// EXPECT angles: 0.52359877559829887 57.295779513082323
// EXPECT signs: -1 0 1
// EXPECT rounds: 0 3 0 -3 0
// EXPECT logs: 3 0 0
// EXPECT steps: 0 1 1
// EXPECT smooth: 0.15625 0 1 0.84375
// EXPECT smoothEdges: 0 1 0 1 0.5
// EXPECT filtered: 0 1 0.25 0.25 1 0
surface numbers(float zero = 0, one = 1, two = 2;
                output varying float angles[2] = {0, 0}; output varying float signs[3] = {9, 9, 9};
                output varying float rounds[5] = {9, 9, 9, 9, 9}; output varying float logs[3] = {9, 9, 9};
                output varying float steps[3] = {9, 9, 9}; output varying float smooth[4] = {9, 9, 9, 9};
                output varying float smoothEdges[5] = {9, 9, 9, 9, 9}; output varying float filtered[6] = {9, 9, 9, 9, 9, 9};) {
  angles[0] = radians(30 * one);
  angles[1] = degrees(one);
  signs[0] = sign(-two);
  signs[1] = sign(zero);
  signs[2] = sign(0.001 * one);
  rounds[0] = round(-0.5 * one);
  rounds[1] = round(2.5 * one);
  rounds[2] = round(0.49999997 * one);
  rounds[3] = round(-3.4 * one);
  rounds[4] = round(zero);
  logs[0] = log(8 * one, two);
  logs[1] = log(zero, two);
  logs[2] = log(two, one); // log(1) is 0, and a quotient by 0 is 0
  steps[0] = step(0.5, 0.49 * one);
  steps[1] = step(0.5, 0.5 * one);
  steps[2] = step(0.5, two);
  smooth[0] = smoothstep(zero, one, 0.25);
  smooth[1] = smoothstep(zero, one, -5);
  smooth[2] = smoothstep(zero, one, 1);
  smooth[3] = smoothstep(zero, one, 0.75);
  smoothEdges[0] = smoothstep(one, zero, 0.25); // reversed: the step at the first edge
  smoothEdges[1] = smoothstep(one, one, 1);
  smoothEdges[2] = smoothstep(one, one, 0.999);
  smoothEdges[3] = smoothstep(one, zero, 1);
  smoothEdges[4] = smoothstep(-3e38 * one, 3e38 * one, 0); // whose difference no float holds
  filtered[0] = filterstep(one, 0.1, 0.9);
  filtered[1] = filterstep(zero, 0.1, 0.9);
  filtered[2] = filterstep(0.7 * one, 0.1, 0.9);
  filtered[3] = filterstep(0.7 * one, 0.9, 0.1); // the ends in any order
  filtered[4] = filterstep(0.5 * one, 0.5, 0.5); // nothing to filter over: the step
  filtered[5] = filterstep(0.5 * one, 0.4, 0.4);
}
