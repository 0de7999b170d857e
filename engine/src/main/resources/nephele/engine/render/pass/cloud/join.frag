// Draws the mean of the four pixels around each corner of a layer's pixels. Interpolated between corners, that is the layer
// under a tent of three pixels, which joins the samples that neighbouring rays have taken at other depths.
layout(location = 0) out vec4 pixel;

uniform sampler2D clouds; // premultiplied radiance and coverage

void main() {
    pixel = texture(clouds, floor(gl_FragCoord.xy) / vec2(textureSize(clouds, 0)));
}
