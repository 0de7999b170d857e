#include "frame.glsl"
#include "view-clip.glsl"
#include "dynamic-position.glsl"

// The eye from the anchor as two floats a component.
uniform vec3 eyeHigh;
uniform vec3 eyeLow;
#ifdef PORTALS
uniform float seamPerMetre; // a pixel and a half, at distance 1
#endif

flat out int instance;
flat out float materialIndex;
out vec3 inPart;
out vec3 normalInPart;
out vec3 relativePosition;
out vec3 anchorPosition;
#if defined(TEXTURED) || defined(NORMAL_MAP)
out vec2 onSurface;
#endif

void main() {
    DynamicVertex v = dynamicVertex();
    relativePosition = (v.centreHigh - eyeHigh) + (v.centreLow - eyeLow) + v.fromCentre;
    gl_Position = clipFromRelative * vec4(relativePosition, 1.0);
#ifdef PORTALS
    // An opening covers surfaces up to a pixel in front of it, so the other half must continue that far.
    float margin = seamPerMetre * gl_Position.w;
    clipToView(relativePosition);
    gl_ClipDistance[0] += margin;
    clipToOwnPlanes(v, v.fromCentre - relativePosition, margin);
#endif
    anchorPosition = v.centreHigh + v.fromCentre;
    instance = v.instance;
    inPart = v.inPart;
    normalInPart = normalize(normalAndPart.xyz);
    materialIndex = instanceTexel(v.instance, 1).w + mod(normalAndPart.w, PARTS_STRIDE);
#if defined(TEXTURED) || defined(NORMAL_MAP)
    onSurface = textureCoordinates;
#endif
}
