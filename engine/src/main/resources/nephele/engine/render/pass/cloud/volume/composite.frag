// Draws clouds of low resolution over the pixels whose surface is behind all of them.
#include "output.glsl"
#ifdef MIXED
#include "view-distance.glsl"
#include "cloud-ranges.glsl"
#endif

in vec3 direction;

uniform sampler2D viewDepth;
uniform sampler2D clouds; // premultiplied radiance and coverage

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
    pixel = texture(clouds, gl_FragCoord.xy / (DIVISOR * vec2(textureSize(clouds, 0))));
    if (pixel.a <= 0.0) {
        discard;
    }
}
