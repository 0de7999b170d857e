// Draws the clouds in front of a pixel's surface over it, from what is in front of the nearest and of the farthest surface
// around. Pixels whose surface is clearly between the two, with clouds there, get nothing here.
#include "output.glsl"
#include "view-distance.glsl"

uniform sampler2D viewDepth;
uniform sampler2D surfaceCuts; // what join.frag has drawn, of the cuts and of both layers
uniform sampler2D beforeNearest;
uniform sampler2D beforeFarthest;

const float NEAR = 1.01; // distances whose ratio is less are one
const float FAINT = 0.02; // coverage

void main() {
    vec2 corner = (gl_FragCoord.xy / DIVISOR + 0.5) / vec2(textureSize(beforeNearest, 0));
    vec4 near = texture(beforeNearest, corner);
    vec4 far = texture(beforeFarthest, corner);
    vec2 cuts = texture(surfaceCuts, corner).rg;
    float metres = axisMetres(texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r);
    bool isBetween = metres > NEAR * cuts.x && cuts.y > NEAR * metres;
    if (isBetween && far.a - near.a > FAINT) {
        discard;
    }
    float between = cuts.x < cuts.y ? clamp((metres - cuts.x) / (cuts.y - cuts.x), 0.0, 1.0) : 1.0;
    writeCovering(mix(near, far, between));
}
