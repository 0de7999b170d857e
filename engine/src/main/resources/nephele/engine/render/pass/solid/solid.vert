#include "frame.glsl"
#include "materials.glsl"
#include "lights.glsl"

layout(location = 0) in vec3 position; // in its cell
layout(location = 1) in vec4 normalAndMaterial;
layout(location = 2) in vec2 textureCoordinates;

// The eye in the cell as two floats a component: the difference to a near vertex is exact.
uniform vec3 eyeHigh;
uniform vec3 eyeLow;

#ifdef TEXTURED
out vec2 st;
flat out float colourLayer;
#endif
#ifdef FLAT_LIGHT
flat out vec3 reflectedPerAlbedo;
#else
flat out vec3 faceNormal;
flat out float materialIndex;
out vec3 relativePosition;
#endif
#ifdef EMISSION
flat out vec3 emission;
#endif

void main() {
    vec3 relative = (position - eyeHigh) - eyeLow;
    gl_Position = clipFromRelative * vec4(relative, 1.0);
    vec3 normal = normalize(normalAndMaterial.xyz);
    Material material = materialAt(normalAndMaterial.w);
#ifdef TEXTURED
    st = textureCoordinates;
    colourLayer = material.layers.x;
#endif
#ifdef EMISSION
    emission = material.emissionMetallic.rgb;
#endif
#ifdef FLAT_LIGHT
    // A flat face under parallel light is lit alike everywhere: once per corner is exact.
    vec3 perAlbedo = vec3(0.0);
#ifdef SUN
    perAlbedo += lambert(sunIrradianceOn(normal));
#endif
#ifdef AMBIENT_CONSTANT
    perAlbedo += ambientRadiance;
#endif
    reflectedPerAlbedo = perAlbedo * material.baseColourRoughness.rgb;
#else
    faceNormal = normal;
    materialIndex = normalAndMaterial.w;
    relativePosition = relative;
#endif
}
