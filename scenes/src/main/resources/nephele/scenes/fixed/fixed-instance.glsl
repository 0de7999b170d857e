// The material of a model of an XML scene, by its number.
#include "/nephele/scenes/fixed/fixed-light.glsl"

uniform samplerBuffer looks; // four texels for each model

FixedMaterial fixedMaterial(int model) {
    vec4 ambient = texelFetch(looks, 4 * model);
    vec4 diffuse = texelFetch(looks, 4 * model + 1);
    vec4 specular = texelFetch(looks, 4 * model + 2);
    vec4 emissive = texelFetch(looks, 4 * model + 3);
    return FixedMaterial(
        ambient.rgb, diffuse.rgb, specular.rgb, emissive.rgb, specular.a, int(ambient.a));
}
