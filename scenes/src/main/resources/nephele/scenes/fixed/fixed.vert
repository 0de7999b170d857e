// Instances of one mesh. WIREFRAME, FLAT, GOURAUD or PHONG is defined.
#ifndef WIREFRAME
#include "/nephele/scenes/fixed/fixed-instance.glsl"
#endif

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 textureCoordinates;

uniform usamplerBuffer visibleModels;
uniform samplerBuffer places; // the three rows of world-from-model
uniform int firstVisible;
uniform int firstPlace; // index of the first model in places
uniform vec3 eye;
uniform mat4 clipFromRelative; // from world directions relative to the eye

#ifndef WIREFRAME
out vec2 texturePoint;
#ifdef FLAT
flat out vec3 litColour;
#endif
#ifdef GOURAUD
out vec3 litColour;
#endif
#ifdef PHONG
flat out int modelNumber;
out vec3 worldPoint;
out vec3 worldNormal;
#endif

// Transforms with the cofactor matrix: the transpose of the inverse up to a factor, of which only the sign matters.
vec3 turnedNormal(vec3 row0, vec3 row1, vec3 row2) {
    vec3 n = vec3(dot(cross(row1, row2), normal), dot(cross(row2, row0), normal), dot(cross(row0, row1), normal));
    return unitOrNothing(dot(cross(row0, row1), row2) < 0.0 ? -n : n);
}
#endif

void main() {
    int model = int(texelFetch(visibleModels, firstVisible + gl_InstanceID).r);
    int at = 3 * (model - firstPlace);
    vec4 row0 = texelFetch(places, at);
    vec4 row1 = texelFetch(places, at + 1);
    vec4 row2 = texelFetch(places, at + 2);
    vec4 p = vec4(position, 1.0);
    vec3 world = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
    gl_Position = clipFromRelative * vec4(world - eye, 1.0);
#ifndef WIREFRAME
    texturePoint = textureCoordinates;
    vec3 unitNormal = turnedNormal(row0.xyz, row1.xyz, row2.xyz);
#ifdef PHONG
    modelNumber = model;
    worldPoint = world;
    worldNormal = unitNormal;
#else
    litColour = fixedLit(fixedMaterial(model), world, unitNormal);
#endif
#endif
}
