// Depth in a light's pictures grows with the distance itself: a float whose last three bits shadow-filter.glsl takes tells
// 20 um apart at 40 m.
uniform float depthPerMetre; // 1 / the light's range; 0 for a sun, whose depth is linear as it is

float shadowDepth() {
    return depthPerMetre > 0.0 ? min(depthPerMetre / gl_FragCoord.w, 1.0) : gl_FragCoord.z;
}
