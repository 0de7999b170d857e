// The inverse of tone-mapping.glsl, for passes that add light to drawn pixels. Values that the curve has clipped stay at
// the least radiance that is drawn so. Twin: render.frame.ToneMapping.
#include "exposure.glsl"

vec3 decodedSrgb(vec3 encoded) {
    vec3 power = pow((encoded + 0.055) / 1.055, vec3(2.4));
    return mix(encoded / 12.92, power, greaterThan(encoded, vec3(0.04045)));
}

vec3 radianceOfPixel(vec3 stored) {
    vec3 linear = decodedSrgb(stored);
#ifdef TONE_FILMIC
    // The positive root of the curve's quadratic equation.
    vec3 a = 2.51 - 2.43 * linear;
    vec3 b = 0.03 - 0.59 * linear;
    linear = (sqrt(b * b + 0.56 * a * linear) - b) / (2.0 * a);
#endif
    return linear / max(exposureFactor(), 1e-6);
}
