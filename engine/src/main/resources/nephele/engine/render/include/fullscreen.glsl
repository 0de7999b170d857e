// Vertex stage of a triangle that covers the viewport, computed from its vertex numbers.
vec2 fullScreenCorner() {
    return vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
}
