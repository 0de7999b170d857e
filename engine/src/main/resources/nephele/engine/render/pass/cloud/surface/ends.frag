// The nearest and the farthest surface of a block of pixels; the first is the greater one in a block without any.
#include "view-distance.glsl"

layout(location = 0) out vec2 ends; // metres along the view's axis

uniform sampler2D viewDepth;

void main() {
    const int side = int(DIVISOR);
    ivec2 last = textureSize(viewDepth, 0) - 1;
    ends = vec2(1e30, 0.0);
    for (int y = 0; y < side; y++) {
        for (int x = 0; x < side; x++) {
            ivec2 at = min(side * ivec2(gl_FragCoord.xy) + ivec2(x, y), last);
            float windowDepth = texelFetch(viewDepth, at, 0).r;
            if (windowDepth < 1.0) {
                float metres = axisMetres(windowDepth);
                ends = vec2(min(ends.x, metres), max(ends.y, metres));
            }
        }
    }
}
