// Every shader here takes `active` first: where it is 0, the point's lane idles and its inputs are poison.
#define CASE varying float active = 1;
#define IF_ACTIVE if (active > 0.5)
