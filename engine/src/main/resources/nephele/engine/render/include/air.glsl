// The air of a sky of kind atmosphere between the eye and a point. Twin: nephele.engine.atmosphere.AerialTable.
#include "frame.glsl"

// By azimuth from the light, elevation and distance: square roots of radiance per unit irradiance of the light and share
// of the range, and the extinction at 680 nm, averaged along the path. The slices of the sun come first, then the moon's.
uniform sampler3D airTable;

const vec3 AIR_SIZE = vec3(24.0, 65.0, 24.0);
const float AIR_MIDDLE = 100000.0; // metres
const float AIR_FARTHEST = 2.0 / 3.0; // share of the range
const float AIR_RAYLEIGH_HEIGHT = 8000.0; // metres
const float AIR_PLANET_RADIUS = 6360000.0; // metres
// Scattering by molecules at the ground at 680, 550 and 440 nm, less that at 680 nm, per metre.
const vec3 AIR_MORE_THAN_RED = vec3(0.0, 7.756e-6, 27.298e-6);
const float AIR_LEVEL = 10.0; // metres of rise within which the density does not change

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

// Returns the entry for sun (0) or moon (1) on a path in a horizontal direction.
vec4 airEntry(int light, vec2 heading, float row, float slice) {
    float azimuth = dot(heading, airTowards[light].xy);
    vec3 place = vec3(sqrt(max(0.5 - 0.5 * azimuth, 0.0)), row, slice) * (1.0 - 1.0 / AIR_SIZE) + 0.5 / AIR_SIZE;
    place.z = 0.5 * (place.z + float(light));
    return texture(airTable, place);
}

// relativePosition: of the point, from the eye. Behind an opening the eye is a virtual one.
Air airAlong(vec3 relativePosition) {
    float flatSquare = dot(relativePosition.xz, relativePosition.xz);
    float flatMetres = sqrt(flatSquare);
    float metres = sqrt(flatSquare + relativePosition.y * relativePosition.y);
    float range = metres / (metres + AIR_MIDDLE);
    float t = relativePosition.y / max(metres + flatMetres, 1e-6);
    float fromHorizon = t - airPlace.y;
    float share = sqrt(abs(fromHorizon) / (fromHorizon < 0.0 ? 1.0 + airPlace.y : 1.0 - airPlace.y));
    vec2 heading = relativePosition.xz / max(flatMetres, 1e-6);
    float row = fromHorizon < 0.0 ? 0.5 - 0.5 * share : 0.5 + 0.5 * share;
    float slice = sqrt(range * (1.0 / AIR_FARTHEST));
    vec4 sunlit = airEntry(0, heading, row, slice);
    vec3 inScatter = airIrradiance[0].rgb * sunlit.rgb * sunlit.rgb;
#ifdef MOONLIT_AIR
    // The moon's slices may not be filled before it shines.
    vec3 moonlit = airIrradiance[1].a > 0.0 ? airEntry(1, heading, row, slice).rgb : vec3(0.0);
    inScatter += airIrradiance[1].rgb * moonlit * moonlit;
#endif
    float density = meanAirDensity(relativePosition.y + flatSquare * (0.5 / AIR_PLANET_RADIUS));
    vec3 extinction = max(vec3(sunlit.a * 1e-4) + AIR_MORE_THAN_RED * density, 0.0);
    return Air(min(range, AIR_FARTHEST) * inScatter, exp(-metres * extinction));
}

// Returns the radiance of a point as the eye sees it.
vec3 throughAir(vec3 radiance, vec3 relativePosition) {
    Air air = airAlong(relativePosition);
    return radiance * air.transmittance + air.inScatter;
}
