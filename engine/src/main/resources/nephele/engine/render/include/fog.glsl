// The attenuation of homogeneous fog and its own radiance. Twin: nephele.engine.level.appearance.FogTransmittance.

// fog: rgb its own radiance, a extinction per metre.
vec3 behindFog(vec3 radiance, vec4 fog, float metres) {
    return mix(fog.rgb, radiance, exp(-fog.a * metres));
}
