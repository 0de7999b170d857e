// Adds each cell to the two bins around its value: two points for each cell.

uniform sampler2D cells;

flat out float weight;

void main() {
    int cell = gl_VertexID / 2;
    float brightness = texelFetch(cells, ivec2(cell % COLUMNS, cell / COLUMNS), 0).x;
    float at = clamp((brightness - DARKEST_LOG2) * BINS_PER_STOP, 0.0, BINS - 1.0);
    float bin = min(floor(at), BINS - 2.0);
    float upper = floor((at - bin) * CELL_WEIGHT + 0.5);
    bool isUpper = gl_VertexID % 2 == 1;
    weight = isUpper ? upper : CELL_WEIGHT - upper;
    float place = isUpper ? bin + 1.0 : bin;
    if (brightness <= HIDDEN) {
        place = BINS;
    } else if (brightness <= BLACK) {
        weight = 0.0;
    }
    gl_Position = vec4((2.0 * place + 1.0) / (BINS + 1.0) - 1.0, 0.0, 0.0, 1.0);
}
