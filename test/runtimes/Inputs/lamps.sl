// Light shaders for light-shaders.sl, each in a category of its own name.

light key(float intensity = 4; point from = (0, 0, 2); string __category = "warm,key"; output varying float seen = 0;
          output varying vector way = 0;) {
  illuminate (from) {
    Cl = intensity * color(1, 2, 3) / (L . L);
    seen = xcomp(Ps) + 1;
    way = L;
  }
}

light cone(point from = (0.5, 0, 1); vector axis = (0, 0, -1); float angle = 0.4; string __category = "cone") {
  illuminate (from, axis, angle)
    Cl = 1;
}

// Of several statements the last that holds the point counts, and none where no branch is taken.
light branch(string __category = "branch") {
  if (xcomp(Ps) > 0.5) {
    illuminate (point (0, 0, 3))
      Cl = 1;
  } else if (xcomp(Ps) < 0.25) {
    solar (vector (0, 0, -1), 0)
      Cl = 2;
    illuminate (point (0, 0, 9), vector (1, 0, 0), 0.1)
      Cl = 100;
  }
}

// Outside of the cone there is no light, whatever Cl is.
light outside(string __category = "outside") {
  Cl = 3;
  illuminate (point (0, 0, 1), vector (0, 0, -1), PI / 4)
    Cl *= 2;
}

light sky(string __category = "sky") {
  solar ()
    Cl = 0.5;
}

light noisy(string __category = "noisy") {
  solar (vector (0, 0, -1), 0)
    Cl = color(random(), noise(4 * Ps), random());
}

light facing(string __category = "facing") {
  solar (vector (0, 0, -1), 0)
    Cl = color(xcomp(Ns), ycomp(Ns), zcomp(Ns));
}

light surroundings(string __category = "surroundings") {
  solar (vector (0, 0, -1), 0) {
    Cl = color(s, t, time);
    Ol = color(u, v, 0.5);
  }
}

light direct(string __category = "direct") {
  Cl = 1;
  L = vector (0, 0, -2);
}

light here(string __category = "here") {
  illuminate (P)
    Cl = N;
}

light glow(string __category = "glow") { Cl = xcomp(Ps); }

light weighted(output varying float __nondiffuse = 0; output varying float __nonspecular = 0;) {
  __nondiffuse = step(0.5, xcomp(Ps));
  __nonspecular = 1 - __nondiffuse;
  solar (vector (0, 0, -1), 0)
    Cl = 1;
}

// Classic ambient lights set L to 0.
light classic() {
  L = 0;
  Cl = 0.5;
}
light triples() {
  Cl = 0.125;
  L = vector (0, 0, 0);
}
