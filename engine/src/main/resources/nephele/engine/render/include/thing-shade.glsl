// Shadows of what moves, beside those of what never moves: depth maps that are drawn when something has moved.
// Written by render.frame.ThingShade. Needs shadow-filter.glsl.

layout(std140) uniform ThingShade {
    mat4 thingMapFromAnchor; // metres from the anchor -> texture coordinates and depth, 0 to 1
    vec4 thingMapRight; // unit axis along the sun map's rows; w: texel side / depth range
    vec4 thingMapUp; // unit axis along its columns; w: half a texel side / depth range
    vec4 thingMapUsed; // xy: texels that are in use, from the first on
    vec4 thingLayers[128]; // four lamp layers each: 1 where something that moves is in it
};

#ifdef THING_SUN_SHADOW
uniform sampler2DArray thingSunMap;

float thingSunLitShare(vec3 anchorPosition, vec3 faceNormal, float nDotSun) {
    vec3 m = (thingMapFromAnchor * vec4(anchorPosition, 1.0)).xyz;
    vec2 size = vec2(textureSize(thingSunMap, 0).xy);
    vec2 texel = m.xy * size;
    if (any(lessThan(texel, vec2(1.0))) || any(greaterThan(texel, thingMapUsed.xy - 1.0)) || m.z < 0.0) {
        return 1.0;
    }
    vec2 gradient = vec2(dot(faceNormal, thingMapRight.xyz), dot(faceNormal, thingMapUp.xyz))
            * (thingMapRight.w / max(nDotSun, 1e-4));
    Footprint four = footprintAt(texel);
    vec4 depths = textureGather(thingSunMap, vec3(gatherPoint(texel) / size, 0.0));
    vec4 nearerBy = nearerThanPlane(depths, m.z, gradient, four);
    return litShare(nearerBy, four.weight, thingMapUp.w, abs(gradient.x) + abs(gradient.y));
}
#endif

#ifdef THING_LAMP_SHADOW
uniform sampler2DArray thingLampMaps;

// What a lamp's picture shows, the nearer of what never moves and what does.
vec4 nearerDepths(vec4 depths, vec3 coordinates) {
    int layer = int(coordinates.z);
    if (thingLayers[layer / 4][layer % 4] > 0.0) {
        return min(depths, textureGather(thingLampMaps, coordinates));
    }
    return depths;
}
#endif
