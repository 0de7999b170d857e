#include "tone-mapping.glsl"

uniform sampler2D linearPicture;

flat in float factor;

layout(location = 0) out vec4 pixel;

void main() {
    vec4 stored = texelFetch(linearPicture, ivec2(gl_FragCoord.xy), 0);
    pixel = vec4(toneMapped(stored.rgb, factor), 1.0);
#ifdef DISTANCE_STORED
    pixel.a = stored.a;
#endif
}
