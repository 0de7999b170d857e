uniform sampler2D openingPicture;

in vec3 picturePosition;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = texture(openingPicture, 0.5 * picturePosition.xy / picturePosition.z + 0.5);
#ifndef EXPOSURE_METERED
    pixel.a = 1.0; // else the share that is metered
#endif
}
