// The pattern in which the mesh of a plant gives place to its impostor.

// A threshold of the pixel, of 64 in an 8 x 8 square (Bayer 1973).
float plantThreshold() {
    ivec2 at = ivec2(gl_FragCoord.xy) & 7;
    int bits = at.x ^ at.y;
    int order = (bits & 1) << 5 | (at.y & 1) << 4 | (bits & 2) << 2 | (at.y & 2) << 1 | (bits & 4) >> 1 | (at.y & 4) >> 2;
    return (float(order) + 0.5) / 64.0;
}
