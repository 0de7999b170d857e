// The edges of a picture, found by pass/edge/edges.frag.

uniform sampler2D edges;

// Returns the edges at a pixel's left and lower side, then those of its lower and left neighbour; none outside.
vec4 edgesAt(ivec2 at) {
    return texelFetch(edges, clamp(at, ivec2(0), textureSize(edges, 0) - 1), 0);
}

// Returns whether there is an edge at a pixel's left, lower, right and upper side.
vec4 surroundingEdges(ivec2 at) {
    ivec2 most = textureSize(edges, 0) - 1;
    float right = edgesAt(at + ivec2(1, 0)).r * float(at.x < most.x);
    float upper = edgesAt(at + ivec2(0, 1)).g * float(at.y < most.y);
    return vec4(edgesAt(at).rg, right, upper);
}
