// Shadows of dynamic objects, in addition to those of static geometry: depth maps that are drawn when an object has
// moved. Written by render.resource.DynamicShadows. Needs shadow-filter.glsl.

layout(std140) uniform DynamicShade {
    mat4 dynamicMapFromAnchor; // metres from the anchor -> texture coordinates and depth, 0 to 1
    vec4 dynamicMapRight; // unit axis along the sun map's rows; w: texel side / depth range
    vec4 dynamicMapUp; // unit axis along its columns; w: half a texel side / depth range
    vec4 dynamicMapUsed; // xy: number of used texels, from the first on
    vec4 dynamicLayers[128]; // four light layers each: 1 if the layer contains a dynamic object
};

#ifdef DYNAMIC_SUN_SHADOW
uniform sampler2DArray dynamicSunMap;

float dynamicSunLitShare(vec3 anchorPosition, vec3 faceNormal, float nDotSun) {
    vec3 m = (dynamicMapFromAnchor * vec4(anchorPosition, 1.0)).xyz;
    vec2 size = vec2(textureSize(dynamicSunMap, 0).xy);
    vec2 texel = m.xy * size;
    if (any(lessThan(texel, vec2(1.0))) || any(greaterThan(texel, dynamicMapUsed.xy - 1.0)) || m.z < 0.0) {
        return 1.0;
    }
    vec2 gradient = vec2(dot(faceNormal, dynamicMapRight.xyz), dot(faceNormal, dynamicMapUp.xyz))
            * (dynamicMapRight.w / max(nDotSun, 1e-4));
    float slope = abs(gradient.x) + abs(gradient.y);
#ifdef NEAREST_SHADOW
    ivec2 nearest = nearestTexel(texel, size);
    float depth = texelFetch(dynamicSunMap, ivec3(nearest, 0), 0).r;
    float nearerBy = nearestNearerThanPlane(depth, m.z + dot(gradient, vec2(nearest) + 0.5 - texel));
    return litByNearest(nearerBy, dynamicMapUp.w, slope);
#else
    Footprint four = footprintAt(texel);
    vec4 depths = textureGather(dynamicSunMap, vec3(gatherPoint(texel) / size, 0.0));
    vec4 nearerBy = nearerThanPlane(depths, m.z, gradient, four);
    return litShare(nearerBy, four.weight, dynamicMapUp.w, slope);
#endif
}
#endif

#ifdef DYNAMIC_LIGHT_SHADOW
uniform sampler2DArray dynamicLightMaps;

// Returns the depths of a light's picture: the nearer of static geometry and dynamic objects.
#ifdef NEAREST_SHADOW
float nearerDepth(float depth, ivec3 texel) {
    if (dynamicLayers[texel.z / 4][texel.z % 4] > 0.0) {
        return min(depth, texelFetch(dynamicLightMaps, texel, 0).r);
    }
    return depth;
}
#else
vec4 nearerDepths(vec4 depths, vec3 coordinates) {
    int layer = int(coordinates.z);
    if (dynamicLayers[layer / 4][layer % 4] > 0.0) {
        return min(depths, textureGather(dynamicLightMaps, coordinates));
    }
    return depths;
}
#endif
#endif
