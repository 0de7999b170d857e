// The light of the portal gun's own lamps on it; twin: scene.dynamic.GunLight of the tests. Positions are the gun's own.

const vec3 CHAMBER = java(scene.dynamic.GunMesh.CHAMBER);
const vec3 HOOP = java(scene.dynamic.GunMesh.HOOP);
const vec2 HOOP_HALF = vec2(java(scene.dynamic.GunMesh.HOOP_HALF_WIDTH_METRES), java(scene.dynamic.GunMesh.HOOP_HALF_HEIGHT_METRES));
const float LAMP_REACH = java(scene.dynamic.GunMesh.LAMP_REACH_METRES);
const float FLASH_REACH = java(scene.dynamic.GunMesh.FLASH_REACH_METRES);
const float WRAPPED = java(scene.dynamic.GunMesh.WRAPPED);

float lampLight(vec3 p, vec3 n, vec3 lamp, float reach) {
    vec3 towards = lamp - p;
    float square = dot(towards, towards);
    float facing = dot(n, towards) * inversesqrt(max(square, 1e-10));
    return max(0.0, mix(facing, 1.0, WRAPPED)) * reach * reach / (square + reach * reach);
}

// Returns the point of the hoop that is nearest in direction.
vec3 hoopNear(vec3 p) {
    vec2 out2 = (p.xy - HOOP.xy) / HOOP_HALF;
    return vec3(HOOP.xy + HOOP_HALF * out2 / max(length(out2), 1e-5), HOOP.z);
}

// Returns the light of the lamps, and that of a shot's flash in the hoop.
vec2 gunLight(vec3 p, vec3 n) {
    float along = clamp(p.z, CHAMBER.z - 0.03, CHAMBER.z + 0.03);
    float lamps = lampLight(p, n, vec3(CHAMBER.xy, along), LAMP_REACH) + lampLight(p, n, hoopNear(p), LAMP_REACH);
    return vec2(lamps, lampLight(p, n, HOOP, FLASH_REACH));
}
