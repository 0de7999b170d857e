uniform sampler2D shown;

in vec3 picturePosition;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(texture(shown, 0.5 * picturePosition.xy / picturePosition.z + 0.5).rgb, 1.0);
}
