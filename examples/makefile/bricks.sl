#include "pattern.h"

surface bricks(float rows = 8, joint = 0.08;
               color brick = color(0.55, 0.2, 0.12), mortar = color(0.7, 0.68, 0.65);)
{
    float row = floor(t * rows);
    /* Every other row is shifted by half a brick; a brick is twice as long as high. */
    float x = s * rows / 2 + 0.5 * mod(row, 2);
    Ci = mix(mortar, brick, stone(x, t * rows, joint));
    Oi = 1;
}
