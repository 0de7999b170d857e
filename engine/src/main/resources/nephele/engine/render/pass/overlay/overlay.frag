// Coverage from a signed distance field: one screen pixel wide for every size of letters. A negative alpha marks a picture.
uniform sampler2D letters;
uniform sampler2D overlayPicture;

in vec2 texel;
in vec4 tint;
out vec4 picture;

void main() {
    float field = texture(letters, texel / vec2(ATLAS_WIDTH, ATLAS_HEIGHT)).r;
    float texelsInside = (field * 255.0 - 128.0) / STEPS_PER_TEXEL;
    float pixelsPerTexel = 1.0 / max(fwidth(texel.x), 1e-4);
    float coverage = clamp(texelsInside * pixelsPerTexel + 0.5, 0.0, 1.0);
    vec4 colour = texture(overlayPicture, texel / vec2(textureSize(overlayPicture, 0)));
    picture = tint.a < 0.0 ? vec4(colour.rgb, 1.0) : vec4(tint.rgb, tint.a * coverage);
}
