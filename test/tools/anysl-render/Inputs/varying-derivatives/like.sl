// Variables that are given as s, P and Cs are change as those do, on any surface. All is 0.5 where all is right.
surface like(varying float own = 9; varying point place = 9; varying color mixed = 9;) {
  float likeS = abs(Du(own) - Du(s)) + abs(Dv(own) - Dv(s)) + abs(filterwidth(own) - filterwidth(s)) / filterwidth(s);
  float likeP = (length(Du(place) - dPdu) + length(Dv(place) - dPdv)) / length(dPdu);
  color change = abs(Du(mixed) - Du(Cs)) + abs(Dv(mixed) - Dv(Cs));
  Ci = 0.5 + color(likeS, likeP, comp(change, 0) + comp(change, 1) + comp(change, 2));
}
