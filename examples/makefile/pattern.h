/* How far x is from the nearest edge of its cell, where cells are 1 wide: 0 at an edge, 0.5 in the middle. */
float edge(float x) {
    float f = mod(x, 1);
    return min(f, 1 - f);
}

/* 1 on the stone, 0 in a joint of the given width, with a soft border. */
float stone(float x, y, joint) {
    float d = min(edge(x), edge(y));
    return smoothstep(joint / 2, joint, d);
}
