uniform vec3 skyCoefficients[9];

#include "sky-ambient.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: normal.
void main() {
    result = vec4(skyAmbient(texelFetch(inputs, int(gl_FragCoord.x)).xyz), 1.0);
}
