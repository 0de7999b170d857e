// One bilinear sample a pixel: the yardstick that performance bars scale with.
uniform sampler2D checks;

in vec2 across;
out vec4 picture;

void main() {
    picture = texture(checks, across);
}
