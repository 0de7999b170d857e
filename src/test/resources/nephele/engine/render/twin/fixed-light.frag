#include "/nephele/scenes/fixed/fixed-light.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: two lights of three texels; ambient, diffuse, specular with shininess, emissive, point, normal.
void main() {
    int pixel = int(gl_FragCoord.x);
    int at = 12 * pixel + 6;
    vec4 specular = texelFetch(inputs, at + 2);
    FixedMaterial m = FixedMaterial(
        texelFetch(inputs, at).rgb,
        texelFetch(inputs, at + 1).rgb,
        specular.rgb,
        texelFetch(inputs, at + 3).rgb,
        specular.a,
        4 * pixel);
    result = vec4(fixedLit(m, texelFetch(inputs, at + 4).xyz, texelFetch(inputs, at + 5).xyz), 1.0);
}
