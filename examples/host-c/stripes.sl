/* Stripes across s with soft edges. */
surface stripes(color dark = color(0.1, 0.1, 0.4);
                color bright = color(1, 0.9, 0.6);
                float count = 3;
                float blur = 0.2;)
{
    float x = mod(s * count, 1);
    float k = smoothstep(0.5 - blur, 0.5 + blur, abs(2 * x - 1));
    Ci = mix(dark, bright, k);
    Oi = 1;
}
