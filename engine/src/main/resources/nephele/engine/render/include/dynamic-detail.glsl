// Procedural details of surfaces without texture: rounded edges and a panel's groove, by shading alone. The silhouette
// is unchanged.

// Returns x: width of a rounded edge, y: position of the groove, z: half its width; metres, from the smaller side.
vec3 detailSizes(float halfSide) {
    return vec3(min(0.10 * halfSide, 0.03), min(0.30 * halfSide, 0.12), min(0.022 * halfSide, 0.008));
}

// Returns the depth in a groove, 0 to 1, at a distance from its middle; softer if a pixel covers more.
float grooveDepth(float distance, float halfWidth) {
    float soft = max(halfWidth * 0.5, fwidth(distance));
    return (1.0 - smoothstep(halfWidth - 0.5 * soft, halfWidth + soft, abs(distance))) * min(1.0, halfWidth / soft * 2.0);
}

// Returns xyz: the normal in the part's frame, w: a factor on the colour.
vec4 detailOfBox(vec3 p, vec3 n, vec3 halfSides) {
    vec3 inFace = 1.0 - abs(n);
    vec3 sizes = detailSizes(min(halfSides.x, min(halfSides.y, halfSides.z)));
    vec3 toEdge = mix(vec3(1e9), halfSides - abs(p), step(0.5, inFace));
    vec3 bend = clamp(1.0 - toEdge / sizes.x, 0.0, 1.0) * step(0.5, inFace);
    vec3 normal = normalize(n + sign(p) * bend * bend);
    float nearest = min(toEdge.x, min(toEdge.y, toEdge.z));
    float groove = grooveDepth(nearest - sizes.y, sizes.z);
    vec3 across = sign(p) * vec3(equal(toEdge, vec3(nearest)));
    normal = normalize(normal + across * (groove * clamp((nearest - sizes.y) / sizes.z, -1.0, 1.0) * 0.6));
    float worn = 1.0 + 0.10 * max(bend.x, max(bend.y, bend.z));
    return vec4(normal, worn * (1.0 - 0.55 * groove));
}

// Adds grooves around the axis: at a sphere's equator and at the joints of a capsule's ends.
vec4 detailOfRound(vec3 p, vec3 n, vec4 size) {
    vec3 sizes = detailSizes(size.x);
    float height = abs(p.y) - size.w;
    float groove = grooveDepth(height - (size.w > 0.0 ? 0.0 : sizes.y), sizes.z);
    return vec4(n, 1.0 - 0.55 * groove);
}

vec4 detail(int kind, vec3 p, vec3 n, vec4 size) {
    return kind == 0 ? detailOfBox(p, n, size.xyz) : kind == 3 ? vec4(n, 1.0) : detailOfRound(p, n, size);
}
