// Where a vertex of what moves is. Sets gl_ClipDistance[1] and [2] where a level may have portals.
#include "thing-instance.glsl"

layout(location = 0) in vec3 position; // of a shape of unit size
layout(location = 1) in vec4 normalAndPart; // 64 part + material
layout(location = 2) in vec2 textureCoordinates;

uniform int firstInstance;
uniform int partsPerThing;

struct ThingVertex {
    int instance;
    vec3 inPart; // metres, in the part's own frame
    vec3 fromCentre; // metres, world directions
    vec3 centreHigh; // from the anchor; the sum of both is exact
    vec3 centreLow;
};

ThingVertex thingVertex() {
    ThingVertex v;
    int part = int(normalAndPart.w) / int(PARTS_STRIDE);
    v.instance = firstInstance + partsPerThing * gl_InstanceID + part;
    vec4 size = instanceTexel(v.instance, 3);
    v.inPart = position * size.xyz;
    // The halves of a capsule.
    v.inPart.y += textureCoordinates.y > 0.5 ? size.w : -size.w;
    v.fromCentre = turned(instanceTexel(v.instance, 0), v.inPart);
    v.centreHigh = instanceTexel(v.instance, 1).xyz;
    v.centreLow = instanceTexel(v.instance, 2).xyz;
    return v;
}

// Leaves what lies before the planes that cut a part, and up to `margin` behind them.
void clipToOwnPlanes(ThingVertex v, float margin) {
#ifdef PORTALS
    vec4 first = instanceTexel(v.instance, 4);
    vec4 second = instanceTexel(v.instance, 5);
    gl_ClipDistance[1] = dot(first.xyz, v.fromCentre) + first.w + margin;
    gl_ClipDistance[2] = dot(second.xyz, v.fromCentre) + second.w + margin;
#endif
}
