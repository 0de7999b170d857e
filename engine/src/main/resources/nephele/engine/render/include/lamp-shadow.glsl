// Share of a lamp's light that arrives: layers of one depth texture, one for a narrow spot, six for the rest, drawn
// once. Geometry: nephele.engine.scene.light.LampShadows. Needs lamps.glsl and shadow-filter.glsl.

// Depth: distance along the picture's axis over the lamp's range; written by lamp-depth.glsl.
uniform sampler2DArray lampShadowMaps;

// fromLamp: metres; faceNormal: of the lit face, towards the lamp.
float lampLitShare(Lamp lamp, vec3 fromLamp, vec3 faceNormal) {
    vec3 q;
    vec3 n;
    float layer = floor(lamp.shadow.w);
    float cotangent = lamp.shadow.x;
    if (lamp.shadow.w > layer) {
        vec3 up = cross(lamp.axis.xyz, lamp.shadow.xyz);
        cotangent = length(lamp.shadow.xyz);
        mat3 view = mat3(lamp.shadow.xyz / cotangent, up / cotangent, lamp.axis.xyz);
        q = fromLamp * view;
        n = faceNormal * view;
    } else {
        vec3 a = abs(fromLamp);
        bool isX = a.x >= max(a.y, a.z);
        bool isY = !isX && a.y >= a.z;
        vec3 p = isX ? fromLamp.yzx : isY ? fromLamp.zxy : fromLamp.xyz;
        vec3 m = isX ? faceNormal.yzx : isY ? faceNormal.zxy : faceNormal.xyz;
        float side = p.z < 0.0 ? -1.0 : 1.0;
        layer += (isX ? 0.0 : isY ? 2.0 : 4.0) + (p.z < 0.0 ? 1.0 : 0.0);
        q = vec3(p.xy, p.z * side);
        n = vec3(m.xy, m.z * side);
    }
    float size = float(textureSize(lampShadowMaps, 0).x);
    float distance = max(q.z, 1e-3);
    vec2 texel = (q.xy * (cotangent / distance) * 0.5 + 0.5) * size;
    float range = max(inversesqrt(lamp.position.w), 0.1);
    float planeDistance = min(dot(n, q), -1e-4 * distance);
    float texelsToTangent = 2.0 / (size * cotangent);
    vec2 gradient = n.xy * (texelsToTangent / planeDistance);
    float halfTexel = 0.5 * texelsToTangent * distance / range;
    float slope = (abs(gradient.x) + abs(gradient.y)) * distance * distance / range;
    Footprint four = footprintAt(texel);
    vec3 coordinates = vec3(gatherPoint(texel) / size, layer);
    vec4 depths = textureGather(lampShadowMaps, coordinates);
#ifdef THING_LAMP_SHADOW
    depths = nearerDepths(depths, coordinates);
#endif
    vec4 nearerBy = nearerThanPlaneOfLamp(depths, distance, gradient, range, four);
#if defined(MOVING_RECEIVER) || defined(CURVED_RECEIVER)
    return litShare(nearerBy, four.weight, halfTexel, slope);
#else
    return litShareOfMapped(nearerBy, looksLike(depths, faceNormal), four.weight, halfTexel, slope);
#endif
}
