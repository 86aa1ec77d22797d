// Every kind of light, with and without shadows, left out of diffuse and of specular.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 17x9 --ramp P=-1,-1,0:1,1,0.4:x --light ambient:intensity=0.2 --light point:from=0.2,0.1,1:shadow
// ARGS: --light spot:from=0.5,0.5,1:cone=40:delta=10:beam=3:shadow --light distant:direction=0.2,0.1,-1:nonspecular
// ARGS: --light spot:from=-0.5,0.5,2:cone=20:nondiffuse --light distant:direction=0,0,1:shadow
// PRINT: Ci a b c
surface lights(output varying color a = 0; output varying color b = 0; output varying color c = 0;) {
  normal n = normalize(N + normal (s - 0.5, t - 0.5, 0));
  vector V = normalize(vector (0.2, 0.1, 1));
  a = ambient() + diffuse(n);
  b = specular(n, V, 0.1 + s);
  c = phong(n, V, 1 + 20 * t);
  illuminance (P, n, 0.5)
    Ci += Cl * zcomp(normalize(L));
}
