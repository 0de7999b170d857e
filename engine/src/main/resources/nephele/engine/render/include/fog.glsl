// The attenuation of fog and its own radiance. Twin: nephele.engine.level.appearance.FogTransmittance.
// FOG_LAYER: the fog ends with its altitude; else it is the same everywhere.

#ifdef FOG_LAYER
// Returns the mean of exp(-max(0, x)) between two altitudes, scale heights above the fog's base.
float meanFogDensity(float from, float to) {
    float low = min(from, to);
    float high = max(from, to);
    float lowAbove = max(low, 0.0);
    float above = max(high, 0.0) - lowAbove;
    float share = above > 0.0 ? above / (high - low) : low > 0.0 ? 1.0 : 0.0;
    float decay = above < 1e-2 ? 1.0 - above * (0.5 - above / 6.0) : (1.0 - exp(-above)) / above;
    return mix(1.0, exp(-lowAbove) * decay, share);
}

// Returns the share of the light of the sky that passes. direction: not of unit length
float skyThroughFog(vec3 direction) {
    float above = fogPlace.x < 0.0 ? 1.0 - fogPlace.x : exp(-fogPlace.x);
    float rise = direction.y * inversesqrt(dot(direction, direction));
    return rise <= 0.0 ? 0.0 : exp(-fog.a * above / (fogPlace.y * rise));
}
#endif

// Returns the share of the light of a place that passes. relative: from the eye, metres
float throughFog(vec3 relative) {
#ifdef FOG_LAYER
    return exp(-fog.a * length(relative) * meanFogDensity(fogPlace.x, fogPlace.x + relative.y * fogPlace.y));
#else
    return exp(-fog.a * length(relative));
#endif
}

vec3 behindFog(vec3 radiance, vec3 relative) {
    return mix(fog.rgb, radiance, throughFog(relative));
}
