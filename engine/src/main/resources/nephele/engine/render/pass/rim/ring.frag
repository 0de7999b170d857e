// The rim: a dark housing with a luminous strip whose pattern distinguishes the two shots without colour.
#include "output.glsl"
#include "displayed.glsl"

in vec3 rimPlace;
in vec2 areaPlace;
in vec3 relativePosition;

uniform vec4 tintAndOpacity;
uniform vec4 pattern; // kind, cells around, seconds, half the larger side

const float STRIP_START = 0.020;
const float STRIP_WIDTH = 0.060;
const float CHEVRONS_PER_SECOND = 0.75;

// Returns 1 if x is below the edge, smoothed over a pixel.
float below(float x, float edge) {
    float soft = max(fwidth(x), 1e-4);
    return 1.0 - smoothstep(edge - soft, edge + soft, x);
}

// Arrowheads that move around the rim: the first shot.
float chevrons(float cell, float across) {
    float lean = cell - pattern.z * CHEVRONS_PER_SECOND + abs(across - 0.5) * 1.1;
    float saw = abs(fract(lean) - 0.5) * 2.0;
    float soft = min(2.0 * fwidth(cell), 1.0);
    return mix(1.0 - smoothstep(0.42 - soft, 0.58 + soft, saw), 0.5, smoothstep(0.5, 1.0, soft));
}

// Two static lines: the second shot.
float doubleLine(float cell, float across) {
    float fromLine = abs(abs(across - 0.5) - 0.31);
    float breath = 0.86 + 0.14 * sin(6.2831853 * (cell * 2.0 / pattern.y - pattern.z * 0.25));
    return below(fromLine, 0.12) * breath;
}

// A broad line with studs between dark edges: a portal of the level. The line stands out from dark walls, the edges
// from bright ones; the inner edge does so also where a door frame covers the outer one.
float studs(float cell, float across) {
    float stud = length(vec2((fract(cell) - 0.5) * 3.2, across - 0.5));
    float line = below(abs(across - 0.5), 0.27);
    return max(line * 0.9, 1.0 - smoothstep(0.28, 0.36, stud));
}

void main() {
    float across = (rimPlace.x - STRIP_START) / STRIP_WIDTH;
    float cell = rimPlace.z * pattern.y;
    float lit = pattern.x < 0.5 ? chevrons(cell, across) : pattern.x < 1.5 ? doubleLine(cell, across) : studs(cell, across);
    float strip = below(abs(across - 0.5), 0.5);
    vec3 tint = tintAndOpacity.rgb;
    vec3 towardsEye = normalize(-relativePosition);
    vec3 normal = normalize(cross(dFdx(relativePosition), dFdy(relativePosition)));
    float facing = abs(dot(normal, towardsEye));
    float inner = pattern.x < 1.5 ? 1.0 - smoothstep(0.0, 0.012, rimPlace.x) : 0.0;
    vec3 housing = vec3(0.016, 0.018, 0.022) * (0.5 + facing) + tint * (0.07 * pow(1.0 - facing, 2.0) + 0.55 * inner);
    vec3 hot = mix(tint, vec3(1.0), pattern.x < 1.5 ? 0.22 : 0.4);
    vec3 luminous = mix(tint * (pattern.x < 1.5 ? 0.10 : 0.02), hot * 1.5, lit);
    writeRadiance(radianceOf(mix(housing, luminous, strip)), relativePosition);
    bool isGhost = tintAndOpacity.a < 1.0;
#ifdef EXPOSURE_METERED
    const float whole = 0.0; // replaces the pixel: no share of it is metered
#else
    float whole = SURFACE_ALPHA;
#endif
    pixel.a = isGhost ? tintAndOpacity.a * strip * (0.6 + 0.4 * lit) : whole;
}
