// Share of the sun that arrives: one parallel depth map over all casters, drawn once.
// Geometry: nephele.engine.scene.light.ShadowFrame. Needs shadow-filter.glsl.

uniform sampler2DArray sunShadowMap;
uniform mat4 sunMapFromAnchor;  // metres from the anchor -> texture coordinates and depth, 0 to 1
uniform vec4 sunMapRight;  // unit axis along the map's rows; w: texel side / depth range
uniform vec4 sunMapUp;  // unit axis along its columns; w: half a texel side / depth range

float sunLitShare(vec3 anchorPosition, vec3 faceNormal, float nDotSun) {
    vec3 m = (sunMapFromAnchor * vec4(anchorPosition, 1.0)).xyz;
    vec2 size = vec2(textureSize(sunShadowMap, 0).xy);
    vec2 texel = m.xy * size;
    vec2 gradient = vec2(dot(faceNormal, sunMapRight.xyz), dot(faceNormal, sunMapUp.xyz))
            * (sunMapRight.w / max(nDotSun, 1e-4));
    float slope = abs(gradient.x) + abs(gradient.y);
    Footprint four = footprintAt(texel);
    vec4 depths = textureGather(sunShadowMap, vec3(gatherPoint(texel) / size, 0.0));
    vec4 nearerBy = nearerThanPlane(depths, m.z, gradient, four);
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litShare(nearerBy, four.weight, sunMapUp.w, slope);
#else
    return litShareOfMapped(nearerBy, looksLike(depths, faceNormal), four.weight, sunMapUp.w, slope);
#endif
}
