#include "tone-mapping.glsl"

uniform sampler2D linearPicture;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(toneMapped(texelFetch(linearPicture, ivec2(gl_FragCoord.xy), 0).rgb), 1.0);
}
