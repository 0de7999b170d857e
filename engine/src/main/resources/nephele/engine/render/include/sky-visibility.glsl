// The baked fraction of the hemisphere over a static face that sees the sky; see
// nephele.engine.scene.light.bake.SkyVisibility.

uniform sampler2D skyVisibilityMap;

// Converts sixteenths of a texel, as in vertices, to texture coordinates.
vec2 lightMapCoordinates(vec2 sixteenths) {
    return sixteenths / (16.0 * vec2(textureSize(skyVisibilityMap, 0)));
}

float skyVisibilityAt(vec2 coordinates) {
    return texture(skyVisibilityMap, coordinates).r;
}
