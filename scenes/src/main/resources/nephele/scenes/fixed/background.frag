in vec2 texturePoint;

uniform sampler2D picture;

out vec4 colour;

void main() {
    colour = vec4(texture(picture, texturePoint).rgb, 1.0);
}
