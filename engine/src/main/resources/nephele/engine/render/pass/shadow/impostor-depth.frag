#include "impostor-texels.glsl"

flat in float depthPerRadius;

void main() {
    ImpostorTexel texel = impostorTexel(0.0);
    if (texel.colour.a < 0.5) {
        discard;
    }
    gl_FragDepth = gl_FragCoord.z + depthPerRadius * texel.depth;
}
