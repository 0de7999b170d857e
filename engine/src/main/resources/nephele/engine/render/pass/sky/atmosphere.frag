#include "output.glsl"

in vec3 direction;

// Light around the eye by azimuth from the sun and elevation, square roots: scattered once by aerosols, without phase
// function, then all other light. Per unit solar irradiance.
uniform sampler2DArray skyTable;
uniform vec3 towardsSun;
uniform vec3 irradiance; // of the sun outside the air
uniform vec3 disc; // radiance of the sun's middle
uniform float horizon; // tan(e / 2) of its elevation e
uniform vec2 band; // x: its end as tan(e / 2), y: the share of the sky's rows that are in it
uniform float mieG;
#ifdef NIGHT
uniform vec3 towardsMoon;
uniform vec3 equinox; // axes of the stars
uniform vec3 eastOfEquinox;
uniform vec3 northPole;
uniform vec3 zenithDepth; // optical depth of the air towards the zenith
#endif

const float PI = 3.14159265;
const float SKY_ROWS = 128.0;
const float GROUND_ROWS = 40.0;
const float AZIMUTHS = 80.0;
const float SUN_SINE = 0.0046530; // of its angular radius

float rowOf(float elevation) {
    float above = elevation - horizon;
    if (above < 0.0) {
        return SKY_ROWS + sqrt(sqrt(min(1.0, -above / (horizon + 1.0)))) * (GROUND_ROWS - 1.0);
    }
    float beyond = elevation - band.x;
    float root = sqrt(beyond <= 0.0 ? above / (band.x - horizon) : beyond / (1.0 - band.x));
    return (beyond <= 0.0 ? band.y * root : band.y + (1.0 - band.y) * min(1.0, root)) * (SKY_ROWS - 1.0);
}

vec3 part(vec2 place, float layer) {
    vec3 root = texture(skyTable, vec3(place, layer)).rgb;
    return root * root;
}

// Cornette and Shanks 1992, equation 11; from is 1 + g² − 2g cosine without its cancellation.
float miePhase(float cosine, float fromPeak) {
    float g2 = mieG * mieG;
    float from = (1.0 - mieG) * (1.0 - mieG) + 2.0 * mieG * fromPeak;
    return 3.0 / (8.0 * PI) * (1.0 - g2) * (1.0 + cosine * cosine) / ((2.0 + g2) * from * sqrt(from));
}

// The share of a pixel that a disc fills; it may be smaller than a pixel.
float discInPixel(float sine, float radius, float pixel) {
    float inside = 1.0 - smoothstep(-0.5, 0.5, (sine - radius) / pixel);
    return inside * min(1.0, PI * radius * radius / (pixel * pixel));
}

#ifdef NIGHT
const float MOON_SINE = 0.0045;
const float MOON_ALBEDO = 0.12;
// The night is brighter than in nature by this factor: half floats and eight stops of exposure shall hold it.
const float NIGHT_GAIN = 400.0;
// Light of the night's own air and of unresolved stars, after nautical dusk; per unit irradiance of the sun.
const vec3 NIGHT_GLOW = vec3(0.55, 0.75, 1.25) * 1.6e-8 * NIGHT_GAIN;
const float CELLS = 40.0;

// A sphere that the sun lights, with its seas; per unit irradiance.
vec3 moon(vec3 away, float pixel) {
    float towards = dot(away, towardsMoon);
    vec3 side = (away - towardsMoon * towards) / MOON_SINE;
    float inside = towards > 0.0 ? discInPixel(length(side) * MOON_SINE, MOON_SINE, pixel) : 0.0;
    vec3 normal = normalize(side - (sqrt(max(0.0, 1.0 - dot(side, side))) + 1e-4) * towardsMoon);
    // Its surface is rough: the full moon is nearly as bright at its edge as in its middle.
    float lit = smoothstep(-0.05, 0.35, dot(normal, towardsSun));
    vec2 spot = side.xy * 3.0 + side.z * vec2(1.7, 2.3);
    float seas = 0.5 + 0.25 * sin(spot.x * 2.1 + sin(spot.y * 3.3)) + 0.25 * sin(spot.y * 2.7 + 1.9 * sin(spot.x));
    return vec3(1.0, 0.97, 0.92) * inside * lit * MOON_ALBEDO / PI * mix(1.15, 0.75, seas);
}

uvec3 mixed(uvec3 v) { // M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", 2020: pcg3d
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

// One star in each cell of a cube around the eye, some 9600 to magnitude 6; per unit irradiance of the sun.
vec3 stars(vec3 away, float pixel) {
    vec3 d = vec3(dot(away, equinox), dot(away, eastOfEquinox), dot(away, northPole));
    vec3 size = abs(d);
    int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    float along = d[axis];
    vec2 across = vec2(d[(axis + 1) % 3], d[(axis + 2) % 3]) / abs(along);
    vec2 cell = floor((across * 0.5 + 0.5) * CELLS);
    uvec3 random = mixed(uvec3(uint(cell.x) + 64u, uint(cell.y), uint(axis * 2 + (along > 0.0 ? 1 : 0))));
    vec3 unit = vec3(random >> 8u) / 16777216.0;
    vec2 place = ((cell + 0.15 + 0.7 * unit.xy) / CELLS) * 2.0 - 1.0;
    vec3 star = vec3(0.0);
    star[axis] = sign(along);
    star[(axis + 1) % 3] = place.x;
    star[(axis + 2) % 3] = place.y;
    star = normalize(star);
    float spread = 0.6 * max(pixel, 2e-4);
    float apart = length(d - star);
    // The number of stars grows by 10^0.5 with each magnitude (the sun has -26.74).
    float magnitude = max(-1.0, 6.0 + 2.0 * log2(max(unit.z, 1e-4)) * 0.30103);
    float flux = exp2(-1.328771 * (magnitude + 26.74)) * NIGHT_GAIN;
    vec3 tint = mix(vec3(1.0, 0.8, 0.6), vec3(0.7, 0.85, 1.0), fract(unit.x * 57.0));
    return flux * tint * exp(-apart * apart / (2.0 * spread * spread)) / (2.0 * PI * spread * spread);
}

// What shines beside the sun; per unit irradiance of the sun. It fades in while the sun sets.
vec3 nightLight(vec3 away, float pixel) {
    float starlight = 1.0 - smoothstep(-0.10, 0.0, towardsSun.y);
    float afterDusk = 1.0 - smoothstep(-0.21, -0.105, towardsSun.y);
    vec3 clear = exp(-zenithDepth / (max(away.y, 0.0) + 0.03));
    vec3 glow = afterDusk * NIGHT_GLOW * (1.0 + 0.8 * exp(-5.0 * away.y));
    return starlight * clear * (moon(away, pixel) + stars(away, pixel)) + glow;
}
#endif

void main() {
    vec3 away = normalize(direction);
    float level = length(away.xz);
    float elevation = away.y / (1.0 + level);
    float azimuth = dot(away.xz, towardsSun.xz) / max(level * length(towardsSun.xz), 1e-12);
    vec2 place = vec2(sqrt(clamp(0.5 - 0.5 * azimuth, 0.0, 1.0)) * (AZIMUTHS - 1.0), rowOf(elevation));
    place = (place + 0.5) * vec2(1.0 / AZIMUTHS, 1.0 / (SKY_ROWS + GROUND_ROWS));
    vec3 apart = away - towardsSun;
    float fromPeak = 0.5 * dot(apart, apart);
    float cosine = 1.0 - fromPeak;
    vec3 light = miePhase(cosine, fromPeak) * part(place, 0.0) + part(place, 1.0);
    float pixel = max(length(dFdx(away)), 1e-6);
#ifdef NIGHT
    if (elevation > horizon) {
        light += nightLight(away, pixel);
    }
#endif
    light *= irradiance;
    if (elevation > horizon && cosine > 0.0) {
        // Limb darkening of a grey atmosphere (Eddington's law), with the mean of the disc 1.
        float sine = length(cross(away, towardsSun));
        float fromMiddle = min(1.0, sine / SUN_SINE);
        light += discInPixel(sine, SUN_SINE, pixel) * disc * (0.5 + 0.75 * sqrt(1.0 - fromMiddle * fromMiddle));
    }
    writeRadiance(light);
}
