#include "brdf.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: colour and roughness; metallic and n.v. Reflectance under equal light from all directions.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec4 colour = texelFetch(inputs, at);
    vec4 more = texelFetch(inputs, at + 1);
    Brdf b = brdfOf(colour.rgb, colour.a, more.x, more.y);
    result = vec4(b.diffuse + b.ambientSpecular, 1.0);
}
