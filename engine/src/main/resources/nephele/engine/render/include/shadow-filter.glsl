// Share of a 2 x 2 texel footprint that sees the light, bilinearly weighted. The receiver is taken as a plane and its
// depth evaluated at each texel's own centre, so a lit plane never shades itself, however it slopes, and no offset moves
// the shadow's edge. Twin: nephele.engine.scene.light.ShadowFilter.

// depths: as textureGather returns them around texelPosition (in texels); gradient: change of the receiver's depth from
// texel to texel.
float litShare(vec4 depths, vec2 texelPosition, float receiverDepth, vec2 gradient) {
    vec2 f = texelPosition - 0.5 - floor(texelPosition - 0.5);
    vec4 dx = vec4(-f.x, 1.0 - f.x, 1.0 - f.x, -f.x);
    vec4 dy = vec4(1.0 - f.y, 1.0 - f.y, -f.y, -f.y);
    vec4 plane = min(receiverDepth + gradient.x * dx + gradient.y * dy, 1.0);
    vec4 lit = step(plane, depths);
    vec2 rows = mix(lit.wx, lit.zy, f.x);
    return mix(rows.x, rows.y, f.y);
}

// A face that rises from another one reads texels of that other one at their joint: what lies this little nearer to the
// light does not shade. Half a texel, and up to two more with the receiver's slope.
float contactTolerance(float halfTexelDepth, vec2 gradient) {
    return halfTexelDepth + min(abs(gradient.x) + abs(gradient.y), 4.0 * halfTexelDepth);
}

// Where textureGather reads the four texels around a position without doubt about rounding.
vec2 gatherPoint(vec2 texelPosition) {
    return floor(texelPosition - 0.5) + 1.0;
}
