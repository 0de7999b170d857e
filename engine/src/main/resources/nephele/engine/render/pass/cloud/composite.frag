// Draws clouds of low resolution over the pixels whose surface is behind all of them. MIXED: surfaces can be among the
// clouds; otherwise the depth test leaves the pixels without any.
#include "output.glsl"
#ifdef MIXED
#include "view-distance.glsl"
#include "cloud-ranges.glsl"

in vec3 direction;

uniform sampler2D viewDepth;
#endif

uniform sampler2D clouds; // what join.frag has drawn

void main() {
#ifdef MIXED
    float windowDepth = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (windowDepth < 1.0) {
        float unit = length(direction);
        vec2 range = rangeOfClouds(direction / unit);
        if (range.x >= range.y || axisMetres(windowDepth) * unit < range.y) {
            discard;
        }
    }
#endif
    writeCovering(texture(clouds, (gl_FragCoord.xy / DIVISOR + 0.5) / vec2(textureSize(clouds, 0))));
}
