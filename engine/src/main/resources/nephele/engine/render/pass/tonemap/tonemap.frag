#include "tone-mapping.glsl"

uniform sampler2D linearPicture;

flat in float factor;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(toneMapped(texelFetch(linearPicture, ivec2(gl_FragCoord.xy), 0).rgb, factor), 1.0);
}
