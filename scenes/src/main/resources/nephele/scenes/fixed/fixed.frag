#ifdef WIREFRAME
out vec4 colour;

void main() {
    colour = vec4(1.0);
}
#else
#include "/nephele/scenes/fixed/fixed-instance.glsl"

in vec2 texturePoint;
#ifdef FLAT
flat in vec3 litColour;
#endif
#ifdef GOURAUD
in vec3 litColour;
#endif
#ifdef PHONG
flat in int modelNumber;
in vec3 worldPoint;
in vec3 worldNormal;
#endif

uniform sampler2D picture;

out vec4 colour;

void main() {
#ifdef PHONG
    vec3 litColour = fixedLit(fixedMaterial(modelNumber), worldPoint, unitOrNothing(worldNormal));
#endif
    colour = vec4(litColour * texture(picture, texturePoint).rgb, 1.0);
}
#endif
