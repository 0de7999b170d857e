// Octaves of noise in the plane, each between two generations. Twin: nephele.engine.cloud.octave.OctaveSheet.
const int MOST_OCTAVES = java(render.pass.cloud.procedural.ProceduralTechnique.MOST_OCTAVES);

uniform vec4 octaveScale[MOST_OCTAVES]; // xy: cosine and sine of its turn, in cells a metre; z: weight; w: variance
uniform vec4 octavePlace[MOST_OCTAVES]; // xy: the eye's place in its cell; zw: weights of the generations
uniform ivec4 octaveCell[MOST_OCTAVES]; // xy: the eye's cell; zw: keys of the generations that fade and come
uniform vec3 excess; // x: threshold; y: 1 / greatest excess; z: octaves

uvec3 scrambled(uvec3 v) { // M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", 2020: pcg3d
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

#ifdef SMOOTH
float corner(ivec2 cell, vec2 apart, int key, int mask) {
    uvec3 bits = scrambled(uvec3(cell, key));
    return dot(apart, vec2(bits.xy >> 8u) * (2.0 / 16777216.0) - 1.0);
}

vec2 eased(vec2 t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}
#else
// White noise (Elias).
float corner(ivec2 cell, vec2 apart, int key, int mask) {
    ivec2 texel = cell & mask;
    int n = texel.x + 57 * texel.y + 131 * key;
    n = (n << 13) ^ n;
    return 1.0 - float((n * (n * n * 15731 + 789221) + 1376312589) & 0x7fffffff) / 1073741824.0;
}

vec2 eased(vec2 t) {
    return t;
}
#endif

float generationAt(ivec2 cell, vec2 within, int key, int mask) {
    float a = corner(cell, within, key, mask);
    float b = corner(cell + ivec2(1, 0), within - vec2(1.0, 0.0), key, mask);
    float c = corner(cell + ivec2(0, 1), within - vec2(0.0, 1.0), key, mask);
    float d = corner(cell + ivec2(1, 1), within - vec2(1.0, 1.0), key, mask);
    vec2 share = eased(within);
    return mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
}

// place: relative to the eye, metres
float octaveAt(int index, vec2 place) {
    vec4 scale = octaveScale[index];
    vec4 there = octavePlace[index];
    ivec4 keys = octaveCell[index];
    vec2 along = there.xy + vec2(scale.x * place.x - scale.y * place.y, scale.y * place.x + scale.x * place.y);
    vec2 low = floor(along);
    ivec2 cell = keys.xy + ivec2(low);
    vec2 within = along - low;
    int mask = (32 << index) - 1;
    float value = there.z * generationAt(cell, within, keys.z, mask);
    return there.w == 0.0 ? value : value + there.w * generationAt(cell, within, keys.w, mask);
}

// The mean excess of a normal distribution over 0.
float meanExcess(float mean, float deviation) {
    float z = mean / max(deviation, 1e-6);
    if (deviation < 1e-5 || abs(z) > 5.0) {
        return max(0.0, mean);
    }
    float below = 0.5 + 0.5 * tanh(0.79788456 * (z + 0.044715 * z * z * z));
    return max(0.0, mean * below + deviation * 0.39894228 * exp(-0.5 * z * z));
}

// The optical depth of a column relative to the greatest, on the mean over a square of such an edge: what is finer than that
// counts by its variance.
float columnOfOctaves(vec2 place, float edge) {
    float sum = -excess.x;
    float variance = 0.0;
    for (int i = 0; i < int(excess.z); i++) {
        vec4 scale = octaveScale[i];
        float kept = 1.0 - smoothstep(0.3, 0.9, edge * length(scale.xy));
        sum += kept > 0.0 ? kept * scale.z * octaveAt(i, place) : 0.0;
        variance += (1.0 - kept * kept) * scale.w;
    }
    return excess.y * meanExcess(sum, sqrt(variance));
}
