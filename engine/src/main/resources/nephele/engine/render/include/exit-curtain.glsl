// The light of an exit along a ray. Twin: level.appearance.ExitCurtain.

// SHELL_SHARE is the define ExitCurtain.SHELL_SHARE: thickness of the shell as a share of the radius.
const float BASE = java(level.appearance.ExitCurtain.BASE);
const vec3 LOW_COLOUR = java(level.appearance.ExitCurtain.LOW_COLOUR);
const vec3 HIGH_COLOUR = java(level.appearance.ExitCurtain.HIGH_COLOUR);

// Optical depth of the veil across a shell at a right angle, between two strands of light.
const float VEIL = 2.8;
// What the veil shows in place of what it hides, in linear display values.
const vec3 VEIL_COLOUR = vec3(0.002, 0.018, 0.075);

// Returns the strength of the light around the axis: 1 on average, above it in a strand.
float curtainWaves(vec3 fromFeet, float seconds) {
    float angle = atan(fromFeet.z, fromFeet.x);
    return 1.0
        + 0.4 * sin(5.0 * angle + 0.7 * seconds)
        + 0.3 * sin(12.0 * angle - 1.1 * seconds)
        + 0.2 * sin(23.0 * angle + 1.6 * seconds);
}

// Returns the veil's extinction per metre of a point in the shell. The veil hangs between the strands of light, so that
// a curtain stands out from what is bright as well as from what is dark.
float curtainVeil(vec3 fromFeet, vec2 size, float seconds) {
    float height = clamp(fromFeet.y / size.y, 0.0, 1.0);
    float gap = 1.0 - smoothstep(0.75, 1.1, curtainWaves(fromFeet, seconds));
    return VEIL / (SHELL_SHARE * size.x) * (1.0 - height * height) * gap;
}

// Returns the emission per metre of a point in the shell, in linear display values.
//
// fromFeet: from the base's centre. size: radius and height
vec3 curtainEmission(vec3 fromFeet, vec2 size, float seconds) {
    float height = clamp(fromFeet.y / size.y, 0.0, 1.0);
    float fade = (1.0 - height * height) * (1.0 + 2.0 * exp(-24.0 * height));
    return BASE / (SHELL_SHARE * size.x) * fade * curtainWaves(fromFeet, seconds) * mix(LOW_COLOUR, HIGH_COLOUR, height);
}

// A part of a ray in multiples of its direction; empty if y <= x.
vec2 overlapOf(vec2 a, vec2 b) {
    return vec2(max(a.x, b.x), min(a.y, b.y));
}

// Returns where a ray from the origin is within a slab: offset + rate * t in 0..width.
vec2 withinSlab(float offset, float rate, float width) {
    float safe = abs(rate) < 1e-9 ? 1e-9 : rate;
    float a = -offset / safe;
    float b = (width - offset) / safe;
    return vec2(min(a, b), max(a, b));
}
