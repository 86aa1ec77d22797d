// "send:light:x" reaches a light shader's parameter x for this illuminance, with each point's own value, whatever library, layout
// and number format the light has.
// RUN: rslc %S/Inputs/told.sl -o %t.told.bc
// RUN: anysl-link %t.told.bc -o %t.packet.told.so --width 1,4,8,16
// RUN: anysl-link %t.told.bc -o %t.scalar.told.so --width 1 --runtime scalar --real double
// DEFINE: %{lamps} = --light %t.a.so:told:handle=lamp --light %t.b.so:deaf --light pointlight:from=0,0,2:category=standard \
// DEFINE:   --light %t.a.so:told:level=7:__category=warm,other \
// DEFINE:   --light spotlight:from=0,0,2:to=0,0,0:coneangle=1:conedeltaangle=0.5:category=spot --light distant:direction=0,0,-1:category=sun
// RUN: cp %t.packet.told.so %t.a.so && cp %t.scalar.told.so %t.b.so
// RUN: %shade_everywhere %s %t %{lamps}
// RUN: cp %t.scalar.told.so %t.a.so && cp %t.packet.told.so %t.b.so
// RUN: %shade_everywhere --linked %s %t %{lamps}
// ARGS: --grid 19x2 --ramp P=0,0,0:1,0,0:x --set N=0,0,1
// EXPECT wrong: 0
// EXPECT names: 6

float differ(color a, b) {
  color d = a - b;
  return max(abs(comp(d, 0)), abs(comp(d, 1)), abs(comp(d, 2))) < 1e-4 ? 0 : 1;
}

// What the light gives that nothing was sent to.
color plain() {
  color sum = 0;
  illuminance ("told", P, N, PI / 2)
    sum += Cl;
  return sum;
}

surface telling(output varying float wrong = 0, names = 0;) {
  float x = xcomp(P), heard = -1, found = 0, weights[3] = {1, 0, 0};
  color both[2] = {9, 9}, sum = 0;
  matrix scaled = 1 + x;
  wrong += differ(plain(), color(1, 2, 3));
  illuminance ("told", P, N, PI / 2, "send:light:level", 5 + x, "light:heard", heard) {
    // What is sent does not change what others get, nor what a parameter's default was made of.
    wrong += 10 * differ(Cl, (5 + x) * color(1, 2, 3)) + 100 * differ(plain(), color(1, 2, 3));
    wrong += 1000 * differ(heard, 5 + x + 100 * 2);
    found = lightsource("both", both) + 10 * lightsource("level", sum) + 100 * lightsource("weights", weights);
    wrong += 1e4 * (differ(both[0], color(1, 2, 3)) + differ(both[1], 5 + x) + differ(sum, 5 + x) + differ(found, 111));
    wrong += 1e4 * differ(weights[0], 1);
  }
  // Every type, a position that moves with the point, and a value that converts; what does not fit is not taken.
  weights[2] = x;
  sum = 0;
  illuminance ("told", P, N, PI / 2, "send:light:tint", 2, "send:light:weights", weights, "send:light:m", scaled,
               "send:light:mode", x > 0.5 ? "tenfold" : "plain", "send:light:from", P + vector (0, 0, 1 + x),
               "send:light:level", "text", "send:light:nothing", 3, "send:light:__category", "deaf") {
    sum = Cl;
    wrong += 1e5 * differ(L, vector (0, 0, 1 + x));
  }
  wrong += 1e5 * differ(sum, 2 * (1 + 4 * x) * (1 + x) * (x > 0.5 ? 10 : 1));
  // Nested, and where only some points get there.
  if (mod(floor(18 * x + 0.5), 2) == 0)
    illuminance ("told", P, N, PI / 2, "send:light:level", 2) {
      illuminance ("told", P, N, PI / 2, "send:light:level", 3 + x)
        sum = Cl;
      lightsource("heard", heard);
      wrong += 1e6 * (differ(sum, (3 + x) * color(1, 2, 3)) + differ(heard, 202) + differ(Cl, color(2, 4, 6)));
    }
  // Lights without such a parameter are as ever; those of the standard kinds have the standard's.
  sum = 0;
  illuminance ("deaf,standard", P, N, PI / 2, "send:light:level", 9, "send:light:intensity", 9 + x, "light:intensity", heard)
    sum += Cl;
  wrong += 1e7 * differ(sum, 1 + (9 + x) / (x * x + 4));
  illuminance ("standard", P, N, PI / 2, "send:light:lightcolor", color(1, 2, 3), "send:light:from", P + vector (0, 0, 4),
               "light:lightcolor", sum, "light:intensity", heard)
    wrong += 1e7 * (differ(Cl, color(1, 2, 3) / 16) + differ(L, vector (0, 0, 4)) + differ(sum, color(1, 2, 3)) + differ(heard, 1));
  float square = x * x + 4, narrow = 0;
  illuminance ("spot", P, N, PI / 2, "send:light:beamdistribution", 3, "send:light:intensity", 8)
    wrong += 1e7 * differ(Cl, 8 * pow(2 / sqrt(square), 3) / square);
  illuminance ("spot", P, N, PI / 2, "send:light:coneangle", 0.2, "send:light:conedeltaangle", 0, "send:light:beamdistribution", 0) {
    wrong += 1e7 * differ(Cl, 1 / square);
    narrow = 1;
  }
  wrong += narrow == (x < 2 * tan(0.2)) ? 0 : 1e7;
  illuminance ("sun", P, N, PI / 2, "send:light:to", vector (0, x, -2), "send:light:from", 0, "send:light:coneangle", 0)
    wrong += 1e7 * (differ(L, normalize(vector (0, -x, 2))) + differ(Cl, 1));
  wrong += 1e8 * differ(plain(), color(1, 2, 3));

  // Lights have handles, which are those of other shaders.
  shader all[] = getlights(), warm[] = getlights("category", "warm"), none[] = getlights("category", "nobody"),
         rest[] = getlights("category", "-told,warm");
  names = arraylength(all);
  wrong += 1e9 * (differ(arraylength(warm), 1) + differ(arraylength(none), 0) + differ(arraylength(rest), 4));
  float level = 0, got = getvar(warm[0], "level", level);
  string category = "";
  got += 10 * getvar(all[2], "__category", category) + 100 * getvar(all[1], "level", level);
  wrong += 1e10 * (differ(got, 11) + differ(level, 7)) + (category != "standard" ? 1e10 : 0);
  wrong += all[0] == getshader("lamp") && rest[0] == getshader("light1") && getshader("light6") == null ? 0 : 1e11;
}
