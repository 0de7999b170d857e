// The share of a punctual light that arrives: layers of one depth texture, one for a narrow spot, six for others, drawn
// once. Geometry: nephele.engine.scene.light.LightShadowLayers. Needs punctual-lights.glsl and shadow-filter.glsl.

// Depth: distance along the picture's axis over the light's range; written by light-depth.glsl.
uniform sampler2DArray lightShadowMaps;

// fromLight: metres; faceNormal: of the lit face, towards the light.
float lightLitShare(PunctualLight punctualLight, vec3 fromLight, vec3 faceNormal) {
    vec3 q;
    vec3 n;
    float layer = floor(punctualLight.shadow.w);
    float cotangent = punctualLight.shadow.x;
    if (punctualLight.shadow.w > layer) {
        vec3 up = cross(punctualLight.axis.xyz, punctualLight.shadow.xyz);
        cotangent = length(punctualLight.shadow.xyz);
        mat3 view = mat3(punctualLight.shadow.xyz / cotangent, up / cotangent, punctualLight.axis.xyz);
        q = fromLight * view;
        n = faceNormal * view;
    } else {
        vec3 a = abs(fromLight);
        bool isX = a.x >= max(a.y, a.z);
        bool isY = !isX && a.y >= a.z;
        vec3 p = isX ? fromLight.yzx : isY ? fromLight.zxy : fromLight.xyz;
        vec3 m = isX ? faceNormal.yzx : isY ? faceNormal.zxy : faceNormal.xyz;
        float side = p.z < 0.0 ? -1.0 : 1.0;
        layer += (isX ? 0.0 : isY ? 2.0 : 4.0) + (p.z < 0.0 ? 1.0 : 0.0);
        q = vec3(p.xy, p.z * side);
        n = vec3(m.xy, m.z * side);
    }
    float size = float(textureSize(lightShadowMaps, 0).x);
    float distance = max(q.z, 1e-3);
    vec2 texel = (q.xy * (cotangent / distance) * 0.5 + 0.5) * size;
    float range = max(inversesqrt(punctualLight.position.w), 0.1);
    float planeDistance = min(dot(n, q), -1e-4 * distance);
    float texelsToTangent = 2.0 / (size * cotangent);
    vec2 gradient = n.xy * (texelsToTangent / planeDistance);
    float halfTexel = 0.5 * texelsToTangent * distance / range;
    float slope = (abs(gradient.x) + abs(gradient.y)) * distance * distance / range;
#ifdef NEAREST_SHADOW
    ivec3 nearest = ivec3(nearestTexel(texel, vec2(size)), layer);
    float depth = texelFetch(lightShadowMaps, nearest, 0).r;
#ifdef DYNAMIC_LIGHT_SHADOW
    depth = nearerDepth(depth, nearest);
#endif
    float perDistance = 1.0 / distance + dot(gradient, vec2(nearest.xy) + 0.5 - texel);
    float nearerBy = 1.0 / max(perDistance * range, 1.0) - depth;
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litByNearest(nearerBy, halfTexel, slope);
#else
    return litByNearestOfMapped(nearerBy, looksLike(vec4(depth), faceNormal).x > 0.0, halfTexel, slope);
#endif
#else
    Footprint four = footprintAt(texel);
    vec3 coordinates = vec3(gatherPoint(texel) / size, layer);
    vec4 depths = textureGather(lightShadowMaps, coordinates);
#ifdef DYNAMIC_LIGHT_SHADOW
    depths = nearerDepths(depths, coordinates);
#endif
    vec4 nearerBy = nearerThanPlaneOfLight(depths, distance, gradient, range, four);
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litShare(nearerBy, four.weight, halfTexel, slope);
#else
    return litShareOfMapped(nearerBy, looksLike(depths, faceNormal), four.weight, halfTexel, slope);
#endif
#endif
}
