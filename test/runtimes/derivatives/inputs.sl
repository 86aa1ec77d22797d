// The globals have the derivatives that the host gives: those of their ramps. s = 1 + 2 u, so the second of s s is 8.
// RUN: %shade_everywhere %s %t
// REALS: float double
// ARGS: --grid 5x3 --ramp s=1:3:x --ramp t=0:-5:x --ramp N=0,0,1:0,4,1:y --ramp P=0,0,0:0,3,4:y --ramp I=0,0,-1:0,3,3:y --set dsdv=7
// EXPECT coordinates: 2 7 -5 0
// EXPECT normals: 0 0 0 0 4 0
// EXPECT points: 0 0 0 0 3 4
// EXPECT rest: 0 0 8 0
surface inputs(varying float given = 0;
               output varying float coordinates[4] = {9, 9, 9, 9}; output varying vector normals[2] = {9, 9};
               output varying vector points[2] = {9, 9}; output varying float rest[4] = {9, 9, 9, 9};) {
  coordinates[0] = Du(s);
  coordinates[1] = Dv(s);
  coordinates[2] = Du(t);
  coordinates[3] = Dv(t);
  normals[0] = Du(N);
  normals[1] = Dv(N);
  points[0] = Du(P);
  points[1] = Dv(I);
  rest[0] = Du(given) + Dv(du);
  rest[1] = Du(time) + comp(Dv(Cs), 1);
  rest[2] = Du(Du(s * s));
  rest[3] = Dv(Ng . Ng) + Du(float random());
}
