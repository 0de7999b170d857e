// The position of a dynamic object's vertex. Sets gl_ClipDistance[1] and [2] if a level may have portals.
#include "dynamic-instance.glsl"

layout(location = 0) in vec3 position; // on a shape of unit size
layout(location = 1) in vec4 normalAndPart; // 64 part + material
layout(location = 2) in vec2 textureCoordinates;

uniform int firstInstance;
uniform int partsPerDynamic;

struct DynamicVertex {
    int instance;
    vec3 inPart; // metres, in the part's own frame
    vec3 fromCentre; // metres, world directions
    vec3 centreHigh; // from the anchor; the sum of both is exact
    vec3 centreLow;
};

DynamicVertex dynamicVertex() {
    DynamicVertex v;
    int part = int(normalAndPart.w) / int(PARTS_STRIDE);
    v.instance = firstInstance + partsPerDynamic * gl_InstanceID + part;
    vec4 size = instanceTexel(v.instance, 3);
    v.inPart = position * size.xyz;
    // Moves the halves of a capsule apart.
    v.inPart.y += textureCoordinates.y > 0.5 ? size.w : -size.w;
    v.fromCentre = turned(instanceTexel(v.instance, 0), v.inPart);
    v.centreHigh = instanceTexel(v.instance, 1).xyz;
    v.centreLow = instanceTexel(v.instance, 2).xyz;
    return v;
}

#ifdef PORTALS
float clippedByOwnPlane(DynamicVertex v, vec4 plane, vec3 eyeFromCentre, float margin) {
    float eyeBefore = dot(plane.xyz, eyeFromCentre) + plane.w;
    return dot(plane.xyz, v.fromCentre) + plane.w + (eyeBefore > 1e-3 ? margin : 0.0);
}
#endif

// Keeps the part in front of the planes that cut an object; up to `margin` behind planes with the eye in front.
void clipToOwnPlanes(DynamicVertex v, vec3 eyeFromCentre, float margin) {
#ifdef PORTALS
    gl_ClipDistance[1] = clippedByOwnPlane(v, instanceTexel(v.instance, 4), eyeFromCentre, margin);
    gl_ClipDistance[2] = clippedByOwnPlane(v, instanceTexel(v.instance, 5), eyeFromCentre, margin);
#endif
}
