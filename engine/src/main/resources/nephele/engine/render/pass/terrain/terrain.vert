#include "view-clip.glsl"
#ifdef DETAIL
#include "terrain-detail.glsl"
uniform vec2 halfSteps; // steps of the rasteriser's grid in half the picture

// Returns a place on the grid to which the rasteriser rounds corners. Triangles that have no width may have one on the grid;
// their depth is known only if it comes from the same corners.
vec4 onGrid(vec4 clip) {
    return clip.w > 0.0 ? vec4(round(clip.xy / clip.w * halfSteps) / halfSteps * clip.w, clip.zw) : clip;
}
#else
#include "terrain-position.glsl"
out float height; // metres above the terrain's origin
#endif

out vec2 fieldPosition; // columns and rows from the terrain's first sample
out vec3 relativePosition;
#if defined(ANCHOR_POSITION) && !defined(DETAIL)
uniform vec3 originFromAnchor; // the terrain's origin, metres from the anchor
out vec3 anchorPosition;
#endif

void main() {
#ifdef DETAIL
    DetailVertex v = detailVertex();
    fieldPosition = v.column;
    relativePosition = v.relative;
#else
    ivec2 column = terrainSample();
    height = terrainHeight(column);
    fieldPosition = vec2(column);
    relativePosition = terrainRelative(column, height);
#ifdef ANCHOR_POSITION
    vec2 cell = cellHighLow.xy + cellHighLow.zw;
    anchorPosition = vec3(column.x * cell.x, height, column.y * cell.y) + originFromAnchor;
#endif
#endif
    gl_Position = clipFromRelative * vec4(relativePosition, 1.0);
#ifdef DETAIL
    gl_Position = onGrid(gl_Position);
#endif
    clipToView(relativePosition);
}
