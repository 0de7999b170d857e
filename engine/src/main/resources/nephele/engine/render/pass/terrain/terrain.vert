#include "view-clip.glsl"
#include "terrain-position.glsl"

out vec2 fieldPosition; // columns and rows from the terrain's first sample
out float height; // metres above the terrain's origin
out vec3 relativePosition;
#ifdef ANCHOR_POSITION
uniform vec3 originFromAnchor; // the terrain's origin, metres from the anchor
out vec3 anchorPosition;
#endif

void main() {
    ivec2 column = terrainSample();
    height = terrainHeight(column);
    fieldPosition = vec2(column);
    relativePosition = terrainRelative(column, height);
#ifdef ANCHOR_POSITION
    vec2 cell = cellHighLow.xy + cellHighLow.zw;
    anchorPosition = vec3(column.x * cell.x, height, column.y * cell.y) + originFromAnchor;
#endif
    gl_Position = clipFromRelative * vec4(relativePosition, 1.0);
    clipToView(relativePosition);
}
