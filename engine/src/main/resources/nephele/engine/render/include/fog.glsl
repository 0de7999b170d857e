// What homogeneous fog leaves of what lies behind it, and adds. Twin: nephele.engine.level.appearance.FogVeil.

// fog: rgb its own radiance, a extinction per metre.
vec3 behindFog(vec3 radiance, vec4 fog, float metres) {
    return mix(fog.rgb, radiance, exp(-fog.a * metres));
}
