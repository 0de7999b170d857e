// Draws clouds of low resolution over the pixels whose surface is behind all of them.
#include "output.glsl"
#ifdef MIXED
#include "view-distance.glsl"
#include "cloud-ranges.glsl"
#endif

in vec3 direction;

uniform sampler2D viewDepth;
uniform sampler2D clouds; // premultiplied radiance and coverage

// The layer under a tent of three pixels, which joins the samples that neighbouring rays have taken at other depths.
vec4 joined(vec2 place) {
    vec2 texel = 1.0 / vec2(textureSize(clouds, 0));
    vec2 low = (place - 0.5) * texel;
    vec2 high = (place + 0.5) * texel;
    return 0.25
        * (texture(clouds, low) + texture(clouds, vec2(high.x, low.y)) + texture(clouds, vec2(low.x, high.y))
            + texture(clouds, high));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float windowDepth = texelFetch(viewDepth, at, 0).r;
    if (windowDepth < 1.0) {
#ifdef MIXED
        float unit = length(direction);
        vec2 range = rangeOfClouds(direction / unit);
        if (range.x >= range.y || axisMetres(windowDepth) * unit < range.y) {
            discard;
        }
#else
        discard;
#endif
    }
    pixel = joined(gl_FragCoord.xy / DIVISOR);
    if (pixel.a <= 0.0) {
        discard;
    }
}
