// The vertices of a terrain's tiles, see nephele.engine.math.heightfield.DetailRanges; written by
// render.resource.TerrainTiles.
#include "terrain-position.glsl"

uniform samplerBuffer terrainTiles; // two texels a tile: first column and row, columns between samples; ranges at its corners
uniform vec4 detailView; // DetailView.forward and leastShare
uniform vec3 detailAlong; // DetailView.along

const float TILE_CELLS = java(math.heightfield.HeightFieldDetail.TILE_CELLS);
// DetailRanges; a vertex has arrived shortly before the range, in spite of rounding.
const float MORPH_START = java(math.heightfield.DetailRanges.MORPH_START);
const float MORPH_END = java(math.heightfield.DetailRanges.MORPH_END);
const float SLIDE_START = java(math.heightfield.DetailRanges.SLIDE_START);
const float SLIDE_END = java(math.heightfield.DetailVertex.SLIDE_END);

struct DetailVertex {
    vec2 column; // columns and rows from the terrain's first sample
    vec3 relative; // to the eye
};

// Twin: DetailView.range.
float detailRange(vec3 relative) {
    float distance = length(relative);
    float depth = max(dot(relative, detailView.xyz), 0.0);
    float ahead = max(depth * depth / max(distance, 1e-20), dot(relative, detailAlong));
    return max(ahead, distance * detailView.w);
}

// Returns the vertex that rises or falls from its sample to the next coarser triangles and slides on them to a sample that
// stays. It is exact where it rests and where it has arrived, so that tiles of different levels meet in the same vertices.
DetailVertex detailVertex() {
    vec4 tile = texelFetch(terrainTiles, 2 * gl_InstanceID);
    vec4 ranges = texelFetch(terrainTiles, 2 * gl_InstanceID + 1);
    int between = int(tile.z);
    ivec2 first = ivec2(tile.xy);
    ivec2 here = min(first + between * ivec2(inChunk), chunk.zw);
    ivec2 aside = here & between; // to the edge's other end; zero for a sample of the next coarser level
    float height = terrainHeight(here);
    DetailVertex v = DetailVertex(vec2(here), terrainRelative(here, height));
    vec2 within = vec2(here - first) / (TILE_CELLS * tile.z);
    vec2 alongX = ranges.xz * (1.0 - within.x) + ranges.yw * within.x;
    float share = detailRange(v.relative) / (alongX.x * (1.0 - within.y) + alongX.y * within.y);
    if (share <= MORPH_START || aside == ivec2(0)) {
        return v;
    }
    ivec2 kept = here - aside;
    float end = terrainHeight(kept);
    float coarser = 0.5 * (end + terrainHeight(min(here + aside, chunk.zw)));
    float risen = min((share - MORPH_START) / (MORPH_END - MORPH_START), 1.0);
    v.relative = terrainRelative(here, mix(height, coarser, risen));
    if (share >= SLIDE_END) {
        return DetailVertex(vec2(kept), terrainRelative(kept, end));
    }
    float slid = max((share - SLIDE_START) / (SLIDE_END - SLIDE_START), 0.0);
    v.column = mix(v.column, vec2(kept), slid);
    v.relative = mix(v.relative, terrainRelative(kept, end), slid);
    return v;
}
