// Pixels from the upper left corner to clip space.
layout(location = 0) in vec4 pixelAndTexel;
layout(location = 1) in vec4 colour;

uniform vec4 pictureSize; // pixels; z and w are unused

out vec2 texel;
out vec4 tint;

void main() {
    vec2 corner = pixelAndTexel.xy / pictureSize.xy * 2.0 - 1.0;
    gl_Position = vec4(corner.x, -corner.y, 0.0, 1.0);
    texel = pixelAndTexel.zw;
    tint = colour;
}
