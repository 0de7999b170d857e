// Radiance of a plant. A mesh has a normal; an impostor a mean of many, whose length says how much they agree. Needs
// surface-light.glsl.

// The mean of the cosine over a sphere, where it is positive: what leaves of all directions receive.
const float ALL_DIRECTIONS = 0.25;

#ifdef BOUNCED_LIGHT
flat in vec3 bounced; // radiance of a white surface that only other surfaces light
#endif

// meanNormal: length at most 1; lift: metres towards the sun from where its map is read, which resolves no leaves; sky:
// share that is seen
vec3 plantRadiance(vec3 albedo, vec3 meanNormal, vec3 anchorPosition, float lift, float sky) {
    float agreed = clamp(length(meanNormal), 1e-4, 1.0);
    Surface s;
    s.baseColour = albedo;
    s.normal = meanNormal / agreed;
    s.faceNormal = s.normal;
#ifdef ANCHOR_POSITION
    s.anchorPosition = anchorPosition;
#endif
#ifdef SKY_AMBIENT
    s.skyVisibility = sky;
#endif
#ifdef BOUNCED_LIGHT
    s.bounced = bounced;
#endif
    REFLECTANCE r = reflectanceOf(s);
    vec3 sum = vec3(0.0);
#ifdef AMBIENT
    // The sky's light is nearly linear in the normal.
    Surface open = s;
    open.normal = meanNormal;
    sum += ambientLight(r, open);
#endif
#ifdef LIGHT_PARTS
    r = shown(r);
#endif
#ifdef PUNCTUAL_LIGHTS
    sum += allLights(r, s);
#endif
#ifdef FLASH
    sum += flashLight(r, s);
#endif
#ifdef SUN
    float cosine = max(dot(meanNormal, sunDirection), 0.0) + (1.0 - agreed) * ALL_DIRECTIONS;
    s.normal = sunDirection * cosine;
    s.faceNormal = sunDirection;
#ifdef ANCHOR_POSITION
    s.anchorPosition += lift * sunDirection;
#endif
    sum += sunLight(r, s);
#endif
    return min(sum, vec3(MAX_RADIANCE));
}
