// Nested boxes of cells around a focus, each wider than the one before. In a texture they stand on top of each other, the
// narrowest lowest. ONE_BOX: there is one. Twin: nephele.engine.cloud.cells.CellMarch.
uniform vec4 boxes[MOST_BOXES]; // xy: middle, relative to the eye; zw: 1 / widths
uniform vec4 cells; // x, y: rows of a box in a cloud's density and light; z: boxes; w: share of the next time
uniform vec3 cloudBase; // lower side of the middle or, in a layer, below the focus, relative to the eye, metres
uniform vec3 cloudHalf; // x, z: how far the narrowest box serves; y: height of all boxes, metres

const float WIDENING = java(cloud.cells.CellStack.WIDENING); // widths of successive boxes
const float PER_LOG2 = 0.63092975; // 1 / log2(WIDENING)
const float FADING = java(cloud.cells.CellMarch.FADING); // share of a box's reach, as a logarithm, in which the next one takes over

// The box that serves a place, and the share that the next wider one has already.
vec2 boxOf(vec3 place) {
#ifdef ONE_BOX
    return vec2(0.0);
#else
    vec2 apart = abs(place.xz - cloudBase.xz) / cloudHalf.xz;
    float widenings = PER_LOG2 * log2(max(1e-6, max(apart.x, apart.y)));
    float box = min(cells.z - 1.0, ceil(max(0.0, widenings) - 1e-6));
    float next = box + 1.0 < cells.z ? clamp((widenings - box + FADING) / FADING, 0.0, 1.0) : 0.0;
    return vec2(box, next);
#endif
}

vec2 acrossBox(vec3 place, float box) {
    vec4 there = boxes[int(box)];
    return (place.xz - there.xy) * there.zw + 0.5;
}

// The coordinates of a place in a stack of boxes of so many rows.
vec3 texelOf(vec3 place, float height, float box, float rows) {
    float up = clamp((height - cloudBase.y) / cloudHalf.y, 0.5 / rows, 1.0 - 0.5 / rows);
    vec2 across = acrossBox(place, box);
    return vec3(across.x, (box + up) / cells.z, across.y);
}
