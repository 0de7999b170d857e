// Share of a lamp's light that arrives: layers of one depth texture, one for a narrow spot, six for the rest, drawn
// once. Geometry: nephele.engine.scene.light.LampShadows. Needs lamps.glsl and shadow-filter.glsl.

uniform sampler2DArray lampShadowMaps;

const float LAMP_NEAR_METRES = 0.05;

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
    // Window depth is far / (far - near) - slope / distance, and 1 / distance is linear over the picture of a plane.
    float far = max(inversesqrt(lamp.position.w), 2.0 * LAMP_NEAR_METRES);
    float scale = far / (far - LAMP_NEAR_METRES);
    float slope = scale * LAMP_NEAR_METRES;
    float planeDistance = min(dot(n, q), -0.01 * distance);
    float texelsToTangent = 2.0 / (size * cotangent);
    vec2 gradient = n.xy * (-slope * texelsToTangent / planeDistance);
    float halfTexel = slope * 0.5 * texelsToTangent / distance;
    vec3 coordinates = vec3(gatherPoint(texel) / size, layer);
    vec4 depths = textureGather(lampShadowMaps, coordinates);
#ifdef THING_LAMP_SHADOW
    depths = nearerDepths(depths, coordinates);
#endif
    float depth = scale - slope / distance - contactTolerance(halfTexel, gradient);
    return litShare(depths, texel, depth, gradient);
}
