// The share of the sun that arrives: one parallel depth map of all casters, drawn when the sun moves. Geometry:
// nephele.engine.scene.light.ShadowFrame. Needs shadow-filter.glsl and light.glsl.

uniform sampler2DArray sunShadowMap;

float sunLitShare(vec3 anchorPosition, vec3 faceNormal, float nDotSun) {
    vec3 m = (sunMapFromAnchor * vec4(anchorPosition, 1.0)).xyz;
    vec2 size = vec2(textureSize(sunShadowMap, 0).xy);
    vec2 texel = m.xy * size;
    vec2 gradient = vec2(dot(faceNormal, sunMapRight.xyz), dot(faceNormal, sunMapUp.xyz))
            * (sunMapRight.w / max(nDotSun, 1e-4));
    float slope = abs(gradient.x) + abs(gradient.y);
#ifdef NEAREST_SHADOW
    ivec2 nearest = nearestTexel(texel, size);
    float depth = texelFetch(sunShadowMap, ivec3(nearest, 0), 0).r;
    float nearerBy = nearestNearerThanPlane(depth, m.z + dot(gradient, vec2(nearest) + 0.5 - texel));
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litByNearest(nearerBy, sunMapUp.w, slope);
#else
    return litByNearestOfMapped(nearerBy, looksLike(vec4(depth), faceNormal).x > 0.0, sunMapUp.w, slope);
#endif
#else
    Footprint four = footprintAt(texel);
    vec4 depths = textureGather(sunShadowMap, vec3(gatherPoint(texel) / size, 0.0));
    vec4 nearerBy = nearerThanPlane(depths, m.z, gradient, four);
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litShare(nearerBy, four.weight, sunMapUp.w, slope);
#else
    return litShareOfMapped(nearerBy, looksLike(depths, faceNormal), four.weight, sunMapUp.w, slope);
#endif
#endif
}
