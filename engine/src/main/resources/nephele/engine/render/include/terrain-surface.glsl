// The surface of all samples of a terrain, whatever triangles are drawn, so that light does not depend on their number.
uniform sampler2D terrainHeights;

struct GroundPoint {
    float height; // metres above the terrain's origin
    vec2 rise; // of the triangle, a metre along x and z
};

// Returns the surface at a place in columns and rows. Twin: nephele.engine.math.heightfield.HeightFieldSurface.y.
GroundPoint groundPoint(vec2 place, vec2 cell) {
    ivec2 least = ivec2(clamp(place, vec2(0.0), vec2(textureSize(terrainHeights, 0) - 2)));
    vec2 within = place - vec2(least);
    bool isGreaterZ = within.y >= within.x;
    // One gathering costs a software renderer less than three fetches: x and y are of the row after, y and z of the column after.
    vec4 corners = textureGather(terrainHeights, vec2(least + 1) / vec2(textureSize(terrainHeights, 0)));
    float h00 = corners.w;
    float h11 = corners.y;
    float between = isGreaterZ ? corners.x : corners.z;
    vec2 rise = isGreaterZ ? vec2(h11 - between, between - h00) : vec2(between - h00, h11 - between);
    return GroundPoint(h00 + dot(within, rise), rise / cell);
}
