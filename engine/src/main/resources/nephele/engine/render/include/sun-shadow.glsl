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
            * (sunMapRight.w / max(nDotSun, 0.02));
    vec4 depths = textureGather(sunShadowMap, vec3(gatherPoint(texel) / size, 0.0));
    return litShare(depths, texel, m.z - contactTolerance(sunMapUp.w, gradient), gradient);
}
