// Copies the picture and leaves a mark in the depth of pixels with edges, for smooth.vert: the depth test skips whole blocks
// of pixels without, which a software renderer does not do for a condition in a shader.
#include "surrounding-edges.glsl"

uniform sampler2D displayed;

layout(location = 0) out vec4 pixel;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    pixel = vec4(texelFetch(displayed, at, 0).rgb, 1.0);
    gl_FragDepth = dot(surroundingEdges(at), vec4(1.0)) > 0.0 ? 0.5 : 0.0;
}
