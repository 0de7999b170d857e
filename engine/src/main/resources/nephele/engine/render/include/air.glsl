// The air of a sky of kind atmosphere between the eye and a point. Twin: nephele.engine.atmosphere.AerialTable.
#include "frame.glsl"

// By azimuth from the light, elevation and distance: square roots of radiance per unit irradiance of the light and share
// of the range, and the extinction at 680 nm, averaged along the path. The slices of the sun come first, then the moon's;
// with SHAFTS, those of each light are followed by slices of what the air scatters of it once.
uniform sampler3D airTable;

const vec3 AIR_SIZE = vec3(java(atmosphere.AerialTable.AZIMUTHS), java(atmosphere.AerialTable.ROWS), java(atmosphere.AerialTable.SLICES));
const float AIR_MIDDLE = java(atmosphere.AerialTable.MIDDLE_METRES); // metres
const float AIR_FARTHEST = java(atmosphere.AerialTable.FARTHEST_METRES) / 300000.0; // share of the range
const float AIR_RAYLEIGH_HEIGHT = java(atmosphere.Air.RAYLEIGH_HEIGHT_METRES); // metres
const float AIR_PLANET_RADIUS = java(atmosphere.Air.PLANET_RADIUS_METRES); // metres
// Scattering by molecules at the ground at 680, 550 and 440 nm, less that at 680 nm, per metre.
const vec3 AIR_MORE_THAN_RED = vec3(0.0, 7.756e-6, 27.298e-6);
const float AIR_LEVEL = java(atmosphere.AerialTable.LEVEL_METRES); // metres of rise within which the density does not change

#ifdef SHAFTS
const float AIR_BLOCKS = 4.0;
// By pixel: the share of light scattered once that clouds take on the way to points of the ray up to each of 16 distances,
// four in a layer, equally spaced as the slices of airTable.
uniform sampler2DArray shaftTable;
const float SHAFT_DISTANCES = 16.0;
#else
const float AIR_BLOCKS = 2.0;
#endif

// Light that the air adds, and the share of the light behind that passes.
struct Air {
    vec3 inScatter;
    vec3 transmittance;
};

// Returns the density of the molecules, relative to that at the ground, averaged along a path that rises by these
// metres.
float meanAirDensity(float rise) {
    float end = airPlace.x + rise;
    float column = end < 0.0 ? end : AIR_RAYLEIGH_HEIGHT * (1.0 - exp(end * (-1.0 / AIR_RAYLEIGH_HEIGHT)));
    return abs(rise) < AIR_LEVEL ? airPlace.w : (column - airPlace.z) / rise;
}

// Where a path is in the tables.
struct AirPath {
    vec2 heading; // unit
    float row;
    float slice; // 0 to 1
    float range; // share of the range
    float metres;
};

// relativePosition: of the path's end, from the eye
AirPath airPathTo(vec3 relativePosition) {
    float flatSquare = dot(relativePosition.xz, relativePosition.xz);
    float flatMetres = sqrt(flatSquare);
    float metres = sqrt(flatSquare + relativePosition.y * relativePosition.y);
    float range = metres / (metres + AIR_MIDDLE);
    float t = relativePosition.y / max(metres + flatMetres, 1e-6);
    float fromHorizon = t - airPlace.y;
    float share = sqrt(abs(fromHorizon) / (fromHorizon < 0.0 ? 1.0 + airPlace.y : 1.0 - airPlace.y));
    return AirPath(
        relativePosition.xz / max(flatMetres, 1e-6),
        fromHorizon < 0.0 ? 0.5 - 0.5 * share : 0.5 + 0.5 * share,
        min(1.0, sqrt(range * (1.0 / AIR_FARTHEST))),
        min(range, AIR_FARTHEST),
        metres);
}

// Returns the entry of a block of slices for sun (0) or moon (1).
vec4 airEntry(float block, int light, AirPath path) {
    float azimuth = dot(path.heading, airTowards[light].xy);
    vec3 place = vec3(sqrt(max(0.5 - 0.5 * azimuth, 0.0)), path.row, path.slice);
    place = place * (1.0 - 1.0 / AIR_SIZE) + 0.5 / AIR_SIZE;
    place.z = (block + place.z) / AIR_BLOCKS;
    return texture(airTable, place);
}

#ifdef SHAFTS
// Returns the light that the air scatters once, of the light of which clouds cast shadows.
vec3 scatteredOnce(AirPath path) {
    bool isMoon = airTowards[0].z > 0.5;
    vec3 root = airEntry(isMoon ? 3.0 : 1.0, isMoon ? 1 : 0, path).rgb;
    return path.range * airIrradiance[isMoon ? 1 : 0].rgb * root * root;
}

// Returns the share of that light that clouds take.
float shadedShare(AirPath path, vec3 relativePosition) {
    float ahead = max(dot(relativePosition, viewForward.xyz), 1e-6);
    vec2 seen = vec2(dot(relativePosition, viewRight.xyz) / dot(viewRight.xyz, viewRight.xyz),
        dot(relativePosition, viewUp.xyz) / dot(viewUp.xyz, viewUp.xyz)) / ahead;
    vec2 place = 0.5 + 0.5 * seen;
    float distance = clamp(path.slice * SHAFT_DISTANCES - 1.0, 0.0, SHAFT_DISTANCES - 1.0);
    int nearer = int(distance);
    int farther = min(nearer + 1, int(SHAFT_DISTANCES) - 1);
    vec4 four = texture(shaftTable, vec3(place, float(nearer / 4)));
    vec4 next = nearer / 4 == farther / 4 ? four : texture(shaftTable, vec3(place, float(farther / 4)));
    return mix(four[nearer & 3], next[farther & 3], fract(distance));
}

// Returns the light that the path lacks in the shade of clouds.
vec3 takenByClouds(AirPath path, vec3 relativePosition) {
    return shadedShare(path, relativePosition) * scatteredOnce(path);
}

vec3 takenByClouds(vec3 relativePosition) {
    return takenByClouds(airPathTo(relativePosition), relativePosition);
}
#endif

// relativePosition: of the point, from the eye. Behind an opening the eye is a virtual one.
Air airAlong(vec3 relativePosition) {
    AirPath path = airPathTo(relativePosition);
    vec4 sunlit = airEntry(0.0, 0, path);
    vec3 inScatter = airIrradiance[0].rgb * sunlit.rgb * sunlit.rgb;
#ifdef MOONLIT_AIR
    // The moon's slices may not be filled before it shines.
    vec3 moonlit = airIrradiance[1].a > 0.0 ? airEntry(0.5 * AIR_BLOCKS, 1, path).rgb : vec3(0.0);
    inScatter += airIrradiance[1].rgb * moonlit * moonlit;
#endif
    inScatter *= path.range;
#ifdef SHAFTS
    inScatter = max(inScatter - takenByClouds(path, relativePosition), 0.0);
#endif
    float flatSquare = dot(relativePosition.xz, relativePosition.xz);
    float density = meanAirDensity(relativePosition.y + flatSquare * (0.5 / AIR_PLANET_RADIUS));
    vec3 extinction = max(vec3(sunlit.a * 1e-4) + AIR_MORE_THAN_RED * density, 0.0);
    return Air(inScatter, exp(-path.metres * extinction));
}

// Returns the radiance of a point as the eye sees it.
vec3 throughAir(vec3 radiance, vec3 relativePosition) {
    Air air = airAlong(relativePosition);
    return radiance * air.transmittance + air.inScatter;
}
