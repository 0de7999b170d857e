// Adds each cell to the bin of its value, as a point.

uniform sampler2D cells;

flat out vec4 added;

void main() {
    float brightness = texelFetch(cells, ivec2(gl_VertexID % COLUMNS, gl_VertexID / COLUMNS), 0).x;
    float at = max(brightness - DARKEST_LOG2, 0.0) * BINS_PER_STOP;
    float bin = min(floor(at), BINS - 1.0);
    added = vec4(1.0, floor((at - bin) * STEPS + 0.5), 0.0, 0.0);
    if (brightness <= HIDDEN) {
        bin = BINS;
    } else if (brightness <= BLACK) {
        added = vec4(0.0);
    }
    gl_Position = vec4((2.0 * bin + 1.0) / (BINS + 1.0) - 1.0, 0.0, 0.0, 1.0);
}
