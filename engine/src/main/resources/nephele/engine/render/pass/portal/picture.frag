#include "frame.glsl"

uniform sampler2D openingPicture;

in vec3 picturePosition;

layout(location = 0) out vec4 pixel;

void main() {
    vec2 place = picturePosition.xy / picturePosition.z + vec2(viewRight.w, viewUp.w);
    pixel = texture(openingPicture, 0.5 * place + 0.5);
#if !defined(EXPOSURE_METERED) && !defined(DISTANCE_STORED)
    pixel.a = 1.0; // else the share that is metered, or the distance
#endif
}
