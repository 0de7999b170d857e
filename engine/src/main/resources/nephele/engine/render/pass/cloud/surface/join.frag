// The means of the four blocks around each corner of blocks, for both cuts, as ../join.frag has them of a layer.
layout(location = 0) out vec4 nearest;
layout(location = 1) out vec4 farthest;

uniform sampler2D surfaceCuts;
uniform sampler2D beforeNearest; // premultiplied radiance and coverage; undefined where the cuts are one
uniform sampler2D beforeFarthest;

void main() {
    ivec2 last = textureSize(beforeFarthest, 0) - 1;
    nearest = vec4(0.0);
    farthest = vec4(0.0);
    for (int y = -1; y <= 0; y++) {
        for (int x = -1; x <= 0; x++) {
            ivec2 block = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), last);
            vec2 cuts = texelFetch(surfaceCuts, block, 0).rg;
            vec4 far = texelFetch(beforeFarthest, block, 0);
            vec4 near = texelFetch(beforeNearest, block, 0);
            nearest += 0.25 * (cuts.x < cuts.y ? near : far);
            farthest += 0.25 * far;
        }
    }
}
