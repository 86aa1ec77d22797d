// Globals and varying parameters have the derivatives that the host gives: those of their ramps. s = 1 + 2 u, so the second of s s is 8.
// RUN: %shade_everywhere %s %t
// REALS: float double
// ARGS: --grid 5x3 --ramp s=1:3:x --ramp t=0:-5:x --ramp N=0,0,1:0,4,1:y --ramp P=0,0,0:0,3,4:y --ramp I=0,0,-1:0,3,3:y --set dsdv=7 --ramp number=1:4:y --ramp pair=1,2,3,4,5,6:0,0,0,5,7,9:x --ramp turn=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1:1,0,0,0,0,1,0,0,0,0,1,0,2,0,0,1:x --set still=3
// EXPECT coordinates: 2 7 -5 0
// EXPECT normals: 0 0 0 0 4 0
// EXPECT points: 0 0 0 0 3 4
// EXPECT params: 0 3 1 2 3 2 0
// EXPECT rest: 0 0 8 0
surface inputs(varying float given = 0; varying float number = 0; varying float still = 0; varying color pair[2] = {0, 0};
               varying matrix turn = 1; output varying float params[7] = {9, 9, 9, 9, 9, 9, 9};
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
  params[0] = Du(number) + Du(still) + Dv(still) + Dv(given);
  params[1] = Dv(number);
  color second = Du(pair[1]);
  params[2] = comp(second, 0);
  params[3] = comp(second, 1);
  params[4] = comp(second, 2);
  params[5] = xcomp(Du(transform(turn, point(0, 0, 0))));
  params[6] = comp(Dv(pair[0]), 1);
  rest[0] = Du(given) + Dv(du);
  rest[1] = Du(time) + comp(Dv(Cs), 1);
  rest[2] = Du(Du(s * s));
  rest[3] = Dv(Ng . Ng) + Du(float random());
}
