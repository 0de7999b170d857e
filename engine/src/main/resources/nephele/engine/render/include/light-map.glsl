// The light map of the static faces: SKY_VISIBILITY, the fraction of the hemisphere over a point that sees the sky (nephele.engine.scene.light.bake.SkyVisibility);
// BAKED_LIGHT, of baked-light.glsl.

#ifdef SKY_VISIBILITY
uniform sampler2D skyVisibilityMap;

float skyVisibilityAt(vec2 coordinates) {
    return texture(skyVisibilityMap, coordinates).r;
}
#endif

// Converts sixteenths of a texel, as in vertices, to texture coordinates.
vec2 lightMapCoordinates(vec2 sixteenths) {
#ifdef SKY_VISIBILITY
    return sixteenths / (16.0 * vec2(textureSize(skyVisibilityMap, 0)));
#else
    return sixteenths / (16.0 * vec2(textureSize(bakedLight, 0).xy));
#endif
}
