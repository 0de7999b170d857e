#include "frame.glsl"

uniform sampler2D viewDepth;
uniform sampler2D viewColour;

layout(location = 0) out vec4 pixel;

// Distance along the view's axis: recovers the projection's two numbers from its product with the rotation.
float metres(float windowDepth) {
    vec3 third = vec3(clipFromRelative[0].z, clipFromRelative[1].z, clipFromRelative[2].z);
    return clipFromRelative[3].z / (2.0 * windowDepth - 1.0 - dot(third, viewForward.xyz));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    pixel = vec4(metres(texelFetch(viewDepth, at, 0).r) / 16.0, texelFetch(viewColour, at, 0).rg, 1.0);
}
