// The opacity of a held body: faces are nearly transparent, edges nearly opaque, so that its shape stays legible.

// FACE_OPACITY is the define DynamicPass.HELD_FACE_OPACITY.
const float EDGE_OPACITY = 0.9;
// Width of the line along an edge, and of the face's gradient towards it, relative to the smallest half side.
const float LINE_SHARE = 0.055;
const float FADE_SHARE = 0.35;

float lineAt(float distance, float halfWidth) {
    float soft = max(fwidth(distance), 0.25 * halfWidth);
    return 1.0 - smoothstep(halfWidth - 0.5 * soft, halfWidth + 0.5 * soft, distance);
}

float boxEdge(vec3 p, vec3 n, vec3 halfSides) {
    float smallest = min(halfSides.x, min(halfSides.y, halfSides.z));
    vec3 toEdge = mix(vec3(1e9), halfSides - abs(p), step(0.5, 1.0 - abs(n)));
    float nearest = min(toEdge.x, min(toEdge.y, toEdge.z));
    float fade = clamp(1.0 - nearest / (FADE_SHARE * smallest), 0.0, 1.0);
    return max(lineAt(nearest, LINE_SHARE * smallest), 0.35 * fade * fade);
}

// Rises towards the outline, where a round shape turns away.
float roundEdge(float towardsEye) {
    return 1.0 - smoothstep(0.12, 0.5, towardsEye);
}

float heldOpacity(int kind, vec3 p, vec3 n, vec3 halfSides, float towardsEye) {
    float edge = kind == 0 ? boxEdge(p, n, halfSides) : roundEdge(towardsEye);
    return mix(FACE_OPACITY, EDGE_OPACITY, edge);
}
