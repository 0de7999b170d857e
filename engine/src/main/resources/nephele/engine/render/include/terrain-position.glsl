// The place of a terrain's vertex relative to the eye; written by render.resource.TerrainUniforms.
layout(location = 0) in uvec2 inChunk; // column and row

uniform sampler2D terrainHeights;
uniform ivec4 chunk; // its first column and row; the terrain's last column and row
uniform vec4 cellHighLow; // lengths of a cell along x and z, the higher part, then the rest
uniform vec3 eyeHigh; // the eye, from the terrain's origin
uniform vec3 eyeLow;

ivec2 terrainSample() {
    return min(chunk.xy + ivec2(inChunk), chunk.zw);
}

float terrainHeight(ivec2 column) {
    return texelFetch(terrainHeights, column, 0).r;
}

// Returns the position relative to the eye.
vec3 terrainRelative(ivec2 column, float height) {
    vec3 high = vec3(column.x * cellHighLow.x, height, column.y * cellHighLow.y);
    vec3 low = vec3(column.x * cellHighLow.z, 0.0, column.y * cellHighLow.w);
    return (high - eyeHigh) + (low - eyeLow);
}
