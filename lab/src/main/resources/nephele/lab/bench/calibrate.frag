// One bilinear sample a pixel: the workload by which performance limits are scaled.
uniform sampler2D checks;

in vec2 across;
out vec4 picture;

void main() {
    picture = texture(checks, across);
}
