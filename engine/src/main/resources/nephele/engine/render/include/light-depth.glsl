// Depth in a light's pictures grows with the distance itself: a float without the last three bits, which
// shadow-filter.glsl uses, resolves 20 um at 40 m.
uniform float depthPerMetre; // 1 / the light's range; 0 for a sun, whose depth is already linear

float shadowDepth() {
    return depthPerMetre > 0.0 ? min(depthPerMetre / gl_FragCoord.w, 1.0) : gl_FragCoord.z;
}
