#include "finite.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

void main() {
    result = finite(texelFetch(inputs, int(gl_FragCoord.x)), vec4(7.0));
}
