// Irradiance and radiance that arrive at a surface.
const float INVERSE_PI = 0.31830988618;

// Reflected radiance of a Lambert surface of albedo 1 under an irradiance.
vec3 lambert(vec3 irradiance) {
    return irradiance * INVERSE_PI;
}

#ifdef SUN
uniform vec3 sunDirection; // towards the sun
uniform vec3 sunIrradiance; // on a plane perpendicular to the beam

vec3 sunIrradianceOn(vec3 normal) {
    return sunIrradiance * max(dot(normal, sunDirection), 0.0);
}
#endif

#ifdef AMBIENT_CONSTANT
uniform vec3 ambientRadiance;
#endif
