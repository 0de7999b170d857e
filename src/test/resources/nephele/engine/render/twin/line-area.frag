#include "line-area.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

void main() {
    vec4 line = texelFetch(inputs, int(gl_FragCoord.x));
    result = vec4(areaBeyond(line.x, line.y, line.z, line.w), 0.0, 0.0, 1.0);
}
