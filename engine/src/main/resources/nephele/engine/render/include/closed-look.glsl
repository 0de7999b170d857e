// The surface of a portal without a view: a slow whirl of the portal's colour, nowhere uniform, nowhere black.

float latticeNoise(vec2 p) {
    vec2 cell = floor(p);
    vec2 f = p - cell;
    vec2 s = f * f * (3.0 - 2.0 * f);
    vec4 at = vec4(cell, cell + 1.0);
    vec4 h = fract(sin(at.xzxz * 127.1 + at.yyww * 311.7) * 43758.5453);
    return mix(mix(h.x, h.y, s.x), mix(h.z, h.w, s.x), s.y);
}

mat2 turned(float radians) {
    float c = cos(radians);
    float s = sin(radians);
    return mat2(c, s, -s, c);
}

// Returns linear display values at a place in metres from the aperture's centre.
vec3 closedLook(vec2 place, float halfMetres, vec3 tint, float seconds) {
    float far = length(place) / halfMetres;
    float whole = 6.2831853 * seconds / 3600.0;
    vec2 p = turned(2.6 * exp(-1.7 * far) + whole * 90.0) * place * (2.2 / halfMetres);
    vec2 warp = vec2(latticeNoise(p + 7.0), latticeNoise(turned(-whole * 40.0) * p * 1.3 + 19.0)) - 0.5;
    float cloud = 0.6 * latticeNoise(p * 1.7 + 2.4 * warp) + 0.4 * latticeNoise(p * 3.9 + 3.1 * warp + 31.0);
    float threads = pow(1.0 - abs(2.0 * cloud - 1.0), 5.0);
    vec3 deep = tint * 0.16 + vec3(0.012, 0.014, 0.022);
    return deep + tint * (0.30 * cloud + 0.45 * threads) + vec3(0.10) * threads * threads;
}
