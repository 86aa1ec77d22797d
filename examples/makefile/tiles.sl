#include "pattern.h"

surface tiles(float count = 4, joint = 0.05; color tile = color(0.2, 0.4, 0.5), grout = 0.9;)
{
    Ci = mix(grout, tile, stone(s * count, t * count, joint));
    Oi = 1;
}
