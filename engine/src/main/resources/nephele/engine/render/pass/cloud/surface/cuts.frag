// Where the ray of a block of pixels is cut: at the nearest and the farthest surface of all pixels that it serves, those of the
// block and of the blocks around it. Of a plane it is cut once, in its middle.
layout(location = 0) out vec2 cuts; // metres along the view's axis; 0 without a surface

uniform sampler2D surfaceEnds;

// Farthest by nearest surface.
const float THIN = 1.02; // one cut serves any
const float STEEP = 1.5; // one serves a plane
// Shares of the spread of reciprocal depths, which are linear over the pixels of a plane.
const float WITHIN_BLOCK = 0.35; // a block of n pixels of 3n along a side has less
const float ASYMMETRY = 0.1;

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(surfaceEnds, 0) - 1;
    vec2 ends = vec2(1e30, 0.0);
    for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
            vec2 its = texelFetch(surfaceEnds, clamp(block + ivec2(x, y), ivec2(0), last), 0).rg;
            ends = vec2(min(ends.x, its.x), max(ends.y, its.y));
        }
    }
    vec2 own = texelFetch(surfaceEnds, block, 0).rg;
    vec2 around = 1.0 / max(ends, 1e-6);
    vec2 inBlock = 1.0 / max(own, 1e-6);
    float spread = around.x - around.y;
    bool isPlane = own.y > 0.0 && ends.y < STEEP * ends.x && inBlock.x - inBlock.y < WITHIN_BLOCK * spread
        && abs(inBlock.x + inBlock.y - around.x - around.y) < ASYMMETRY * spread;
    bool isOne = isPlane || ends.y < THIN * ends.x;
    cuts = ends.y == 0.0 ? vec2(0.0) : isOne ? vec2(2.0 / (around.x + around.y)) : ends;
}
