// Draws clouds of low resolution over the pixels without a surface, which the depth test leaves. MIXED: over those with one,
// that is behind all clouds or among them; the latter get nothing here, and are drawn on their own.
#include "output.glsl"
#ifdef MIXED
#include "view-distance.glsl"
#include "cloud-ranges.glsl"

in vec3 direction;

uniform sampler2D viewDepth;
#endif

uniform sampler2D clouds; // what join.frag has drawn

void main() {
    vec4 seen = texture(clouds, (gl_FragCoord.xy / DIVISOR + 0.5) / vec2(textureSize(clouds, 0)));
#ifdef MIXED
    float windowDepth = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (windowDepth < 1.0) {
        float unit = length(direction);
        vec2 range = rangeOfClouds(direction / unit);
        float metres = axisMetres(windowDepth) * unit;
        if (range.x >= range.y || metres <= range.x) {
            discard;
        }
        seen = metres < range.y ? vec4(0.0) : seen;
    }
#endif
    writeCovering(seen);
}
