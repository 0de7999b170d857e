// The light of a flash of lightning on a surface: of the bolt, as from its middle, and of the clouds that it lights. It casts no
// shadows of its own; the share of the sky that a place sees keeps it out of rooms.

// How much of the bolt's light comes in where so much of the sky is seen: under a roof hardly any.
float flashShare(float skyVisibility) {
    float open = clamp(2.0 * skyVisibility, 0.0, 1.0);
    return open * open;
}

vec3 flashLight(REFLECTANCE r, Surface s) {
    vec3 towards = flashPlace.xyz - s.anchorPosition;
    float square = dot(towards, towards);
    towards *= inversesqrt(max(square, 1e-12));
#ifdef SKY_AMBIENT
    float seen = s.skyVisibility;
#else
    float seen = 1.0;
#endif
    float facing = dot(s.faceNormal, towards) > 0.0 ? flashShare(seen) : 0.0;
    vec3 ofBolt = reflected(r, s, towards) * flashIntensity * (facing / (square + flashPlace.w));
    float above = 0.5 + 0.5 * s.normal.y;
#ifdef METALLIC_ROUGHNESS
    vec3 albedo = r.diffuse;
#else
    vec3 albedo = r;
#endif
    return ofBolt + albedo * flashGlow * (seen * above / PI);
}
