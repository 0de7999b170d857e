// Linear radiance to display values; the Java twin is render.frame.ToneMapping.

// CLIP: values above 1 are lost. FILMIC: Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
vec3 toneCurve(vec3 exposed) {
#ifdef TONE_FILMIC
    vec3 x = min(exposed, 1e4);
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
#else
    return min(exposed, 1.0);
#endif
}

// IEC 61966-2-1: linear 0..1 to sRGB 0..1.
vec3 encodeSrgb(vec3 linear) {
    vec3 power = 1.055 * pow(max(linear, 1e-5), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * linear, power, greaterThan(linear, vec3(0.0031308)));
}

// Returns a value between -1/2 and 1/2 exclusive: Roberts' R2 sequence ("The Unreasonable Effectiveness of Quasirandom
// Sequences", 2018) over pixel coordinates in 32-bit fixed point; always the same for a pixel.
float ditherOffset() {
    uvec2 at = uvec2(gl_FragCoord.xy);
    uint fixedPoint = at.x * 3242174889u + at.y * 2447445413u;
    return (float(fixedPoint >> 24) + 0.5) / 256.0 - 0.5;
}

// Applies exposure, tone curve, sRGB and dither, once per pixel; no other code does.
vec3 toneMapped(vec3 radiance, float factor) {
    vec3 encoded = encodeSrgb(toneCurve(max(radiance * factor, 0.0)));
    return encoded + ditherOffset() / 255.0;
}
