#include "output.glsl"
#ifdef SHAFTS
#include "cloud-span.glsl"
#endif

in vec3 direction;

// Light around the eye by azimuth from the sun and elevation, square roots: scattered once by aerosols, without phase
// function, then all other light. Per unit irradiance; two layers of sunlight, two of moonlight.
uniform sampler2DArray skyTable;
uniform vec3 towardsSun;
uniform vec3 irradiance; // of the sun outside the air
uniform vec3 disc; // mean radiance of the sun
uniform float discSine; // of its angular radius
uniform float horizon; // tan(e / 2) of its elevation e at the height of the table
// That at the height of the eye: the table's light moves with the horizon, so a rising eye sees no jump of it.
uniform float horizonOfEye;
uniform vec2 band; // x: its end as tan(e / 2), y: the share of the sky's rows that are in it
uniform float mieG;
#ifdef NIGHT
uniform vec3 towardsMoon;
uniform vec3 moonlight; // its irradiance outside the air; per unit irradiance of the sun
uniform vec3 groundAlbedo; // of the planet
uniform vec3 equinox; // axes of the stars
uniform vec3 eastOfEquinox;
uniform vec3 northPole;
uniform vec3 zenithDepth; // optical depth of the air towards the zenith
#endif

const float PI = 3.14159265;

float rowOf(float elevation) {
    float above = elevation - horizon;
    if (above < 0.0) {
        return float(SKY_ROWS) + sqrt(sqrt(min(1.0, -above / (horizon + 1.0)))) * float(GROUND_ROWS - 1);
    }
    float beyond = elevation - band.x;
    float root = sqrt(beyond <= 0.0 ? above / (band.x - horizon) : beyond / (1.0 - band.x));
    return (beyond <= 0.0 ? band.y * root : band.y + (1.0 - band.y) * min(1.0, root)) * float(SKY_ROWS - 1);
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
const float MOON_SINE = java(level.appearance.Moonlight.RADIUS_SINE);
const float MOON_ALBEDO = java(level.appearance.Moonlight.ALBEDO);
// The night is brighter than in nature by this factor: half floats and eight stops of exposure shall hold it.
const float NIGHT_GAIN = java(level.appearance.Moonlight.NIGHT_GAIN);
// Light of the night's own air and of unresolved stars, after nautical dusk; per unit irradiance of the sun.
const vec3 NIGHT_GLOW = java(level.appearance.CelestialPositions.NIGHT_GLOW);
// The glow's irradiance of a level ground, divided by pi and by the glow of the zenith.
const float GLOW_ON_GROUND = java(level.appearance.CelestialPositions.GLOW_ON_GROUND);
const float CELLS = java(level.appearance.NightSky.STAR_CELLS);

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

// Dark plains: unit vectors to their middles, east, north and towards the planet, and their radii in radians.
const int SEA_COUNT = 15;
const vec4 SEAS[SEA_COUNT] = java(level.appearance.NightSky.SEAS);
// Young craters with bright rays: directions and sizes.
const int RAYED_COUNT = 6;
const vec4 RAYED[RAYED_COUNT] = java(level.appearance.NightSky.RAYED);

float random(ivec3 cell) {
    return float(mixed(uvec3(cell + 4096)).x >> 8u) / 16777216.0;
}

float valueNoise(vec3 p) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - vec3(cell);
    f = f * f * (3.0 - 2.0 * f);
    vec4 low = vec4(
        random(cell), random(cell + ivec3(1, 0, 0)), random(cell + ivec3(0, 1, 0)), random(cell + ivec3(1, 1, 0)));
    vec4 high = vec4(
        random(cell + ivec3(0, 0, 1)), random(cell + ivec3(1, 0, 1)),
        random(cell + ivec3(0, 1, 1)), random(cell + ivec3(1, 1, 1)));
    vec4 between = mix(low, high, f.z);
    vec2 row = mix(between.xy, between.zw, f.y);
    return mix(row.x, row.y, f.x);
}

// The relative albedo of a place on the moon. A count of 0 lets a software renderer leave the loops at once.
float moonAlbedo(vec3 place, bool isSeen) {
    float rough = 0.0;
    float weight = 0.5;
    int octaves = isSeen ? 5 : 0;
    for (int i = 0; i < octaves; i++) {
        rough += weight * (valueNoise(place * (2.7 * exp2(float(i)))) - 0.5);
        weight *= 0.65;
    }
    float sea = 0.0;
    int seas = isSeen ? SEA_COUNT : 0;
    for (int i = 0; i < seas; i++) {
        float apart = length(place - SEAS[i].xyz) / SEAS[i].w;
        sea = max(sea, 1.0 - smoothstep(0.85, 1.25, apart + 1.7 * rough));
    }
    float bright = 0.0;
    int rayed = isSeen ? RAYED_COUNT : 0;
    for (int i = 0; i < rayed; i++) {
        vec3 from = place - RAYED[i].xyz;
        float apart = length(from) / RAYED[i].w;
        vec3 east = normalize(cross(vec3(0.0, 1.0, 0.0), RAYED[i].xyz));
        float angle = atan(dot(from, cross(RAYED[i].xyz, east)), dot(from, east));
        float streak = 0.5 + 0.5 * sin(angle * 9.0 + 2.0 * sin(angle * 4.0 + float(i)));
        bright = max(bright, exp(-1.6 * apart) * (0.15 + 0.85 * streak * streak * streak));
        bright = max(bright, exp(-apart * apart * 90.0));
    }
    return mix(1.0 + 0.6 * rough, 0.5 + 0.3 * rough, sea) + 0.45 * bright;
}

// The share of the pixel that the moon hides.
float moonCover(vec3 away, float pixel) {
    float towards = dot(away, towardsMoon);
    return towards > 0.0 ? discInPixel(length(away - towardsMoon * towards), MOON_SINE, pixel) : 0.0;
}

// A sphere that the sun lights and that shows the planet one side; per unit irradiance.
vec3 moon(vec3 away, float cover) {
    vec3 side = (away - towardsMoon * dot(away, towardsMoon)) / MOON_SINE;
    float outwards = sqrt(max(0.0, 1.0 - dot(side, side))) + 1e-4;
    vec3 normal = normalize(side - outwards * towardsMoon);
    vec3 west = normalize(cross(northPole, towardsMoon));
    vec3 north = cross(towardsMoon, west);
    vec3 place = vec3(-dot(normal, west), dot(normal, north), -dot(normal, towardsMoon));
    float albedo = moonAlbedo(place, cover > 0.0);
    // Lommel and Seeliger's law of a rough surface: the full moon is as bright at its edge as in its middle.
    float sunwards = max(0.0, dot(normal, towardsSun));
    float lit = 2.0 * sunwards / (sunwards + max(outwards, 0.05)) * (0.75 - 0.25 * dot(towardsMoon, towardsSun));
    return vec3(1.0, 0.97, 0.92) * cover * lit * MOON_ALBEDO / PI * albedo;
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

float afterDusk() {
    return 1.0 - smoothstep(-0.21, -0.105, towardsSun.y);
}

// What shines beside the sun; per unit irradiance of the sun. It fades in while the sun sets.
vec3 nightLight(vec3 away, float pixel) {
    float starlight = 1.0 - smoothstep(-0.10, 0.0, towardsSun.y);
    vec3 clear = exp(-zenithDepth / (max(away.y, 0.0) + 0.03));
    vec3 glow = afterDusk() * NIGHT_GLOW * (1.0 + 0.8 * exp(-5.0 * away.y));
    float cover = moonCover(away, pixel);
    return starlight * clear * (moon(away, cover) + (1.0 - cover) * stars(away, pixel)) + glow;
}
#endif

// Light of sun or moon that the air and the ground send to the eye; per unit irradiance of it.
vec3 scattered(vec3 away, float row, vec3 towards, float firstLayer) {
    float azimuth = dot(away.xz, towards.xz) / max(length(away.xz) * length(towards.xz), 1e-12);
    float column = sqrt(clamp(0.5 - 0.5 * azimuth, 0.0, 1.0)) * float(AZIMUTHS - 1);
    vec2 place = (vec2(column, row) + 0.5) * vec2(1.0 / float(AZIMUTHS), 1.0 / float(SKY_ROWS + GROUND_ROWS));
    vec3 apart = away - towards;
    float fromPeak = 0.5 * dot(apart, apart);
    float cosine = 1.0 - fromPeak;
    return miePhase(cosine, fromPeak) * part(place, firstLayer) + part(place, firstLayer + 1.0);
}

void main() {
    vec3 away = normalize(direction);
    // As the tangent of its half, in the table.
    float elevation = away.y / (1.0 + length(away.xz)) - horizonOfEye + horizon;
    float row = rowOf(elevation);
    vec3 light = scattered(away, row, towardsSun, 0.0);
    float pixel = max(length(dFdx(away)), 1e-6);
#ifdef NIGHT
    if (elevation > horizon) {
        light += nightLight(away, pixel);
    } else {
        light += groundAlbedo * GLOW_ON_GROUND * afterDusk() * NIGHT_GLOW;
    }
    if (moonlight.y > 0.0) { // else the moon's layers may not be filled yet
        light += moonlight * scattered(away, row, towardsMoon, 2.0);
    }
#endif
    light *= irradiance;
    if (elevation > horizon && dot(away, towardsSun) > 0.0) {
        // Limb darkening of a grey atmosphere (Eddington's law), with the mean of the disc 1.
        float sine = length(cross(away, towardsSun));
        float fromMiddle = min(1.0, sine / max(discSine, 1e-6));
        light += discInPixel(sine, discSine, pixel) * disc * (0.5 + 0.75 * sqrt(1.0 - fromMiddle * fromMiddle));
    }
#ifdef SHAFTS
    vec3 end = away * min(2.0 * AIR_MIDDLE, planetMetres(away, vec2(0.5 / AIR_PLANET_RADIUS, airPlace.x)));
    light = max(vec3(0.0), light - takenByClouds(end));
#endif
    writeSky(light, away);
}
