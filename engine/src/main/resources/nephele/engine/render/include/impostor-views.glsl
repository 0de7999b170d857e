// Which views of its atlas show a plant from a direction, and where; for a vertex shader. Twins:
// scene.impostor.AtlasView and, in the tests, ViewBlend. Needs plants.glsl.

const float VIEWS = java(scene.impostor.ImpostorAtlas.SIDE); // along a side of the atlas
const float FILLED = java(scene.impostor.ImpostorAtlas.FILLED); // part of a view's side

out vec4 places01; // in each of three views, 0 to 1
out vec2 places2;
out vec4 steps01; // of the places, for a depth of one radius
out vec2 steps2;
flat out vec4 cells01; // corners of the views in the atlas
flat out vec2 cells2;
flat out vec3 viewWeights;
flat out float atlasLayer;

struct AtlasView {
    vec3 towards;
    vec3 right;
    vec3 up;
    vec2 perMetre; // places
};

AtlasView atlasView(vec2 cell, PlantKind kind) {
    vec2 uv = cell * (2.0 / (VIEWS - 1.0)) - 1.0;
    vec3 towards = vec3(0.5 * (uv.x + uv.y), 0.0, 0.5 * (uv.x - uv.y));
    towards.y = max(0.0, 1.0 - abs(towards.x) - abs(towards.z));
    towards = normalize(towards);
    float flatLength = length(towards.xz);
    vec3 right = vec3(towards.z, 0.0, -towards.x) / flatLength;
    float halfHeight = kind.halfHeight * flatLength + kind.halfWidth * towards.y;
    return AtlasView(towards, right, cross(towards, right), 0.5 * FILLED / vec2(kind.halfWidth, halfHeight));
}

vec2 stepIn(AtlasView view, vec3 ray, float radius) {
    return vec2(dot(ray, view.right), dot(ray, view.up)) * view.perMetre * (radius / dot(ray, view.towards));
}

vec2 placeIn(AtlasView view, vec3 fromCentre, vec3 ray) {
    vec3 onPlane = fromCentre - ray * (dot(fromCentre, view.towards) / dot(ray, view.towards));
    return 0.5 + vec2(dot(onPlane, view.right), dot(onPlane, view.up)) * view.perMetre;
}

// All in the plant's frame. toEye: unit, of the plant; fromCentre: the vertex, in metres of the kind; ray: unit, from the
// eye to the vertex
void chooseViews(PlantKind kind, vec3 toEye, vec3 fromCentre, vec3 ray) {
    float sum = max(abs(toEye.x) + max(toEye.y, 0.0) + abs(toEye.z), 1e-12);
    vec2 grid = (0.5 + 0.5 * vec2(toEye.x + toEye.z, toEye.x - toEye.z) / sum) * (VIEWS - 1.0);
    vec2 cell = min(floor(grid), VIEWS - 2.0);
    vec2 part = grid - cell;
    vec2 second = cell + (part.x > part.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    viewWeights = vec3(1.0 - max(part.x, part.y), abs(part.x - part.y), min(part.x, part.y));
    AtlasView a = atlasView(cell, kind);
    AtlasView b = atlasView(second, kind);
    AtlasView c = atlasView(cell + 1.0, kind);
    cells01 = vec4(cell, second) / VIEWS;
    cells2 = (cell + 1.0) / VIEWS;
    places01 = vec4(placeIn(a, fromCentre, ray), placeIn(b, fromCentre, ray));
    places2 = placeIn(c, fromCentre, ray);
    steps01 = vec4(stepIn(a, ray, kind.radius), stepIn(b, ray, kind.radius));
    steps2 = stepIn(c, ray, kind.radius);
}

// Returns the horizontal direction to the right of one who looks at a plant.
vec3 plantRight(vec3 toEye) {
    float level = dot(toEye.xz, toEye.xz);
    return level > 1e-8 ? vec3(toEye.z, 0.0, -toEye.x) * inversesqrt(level) : vec3(1.0, 0.0, 0.0);
}

// Returns half the width and height of the cylinder's outline.
vec2 plantOutline(PlantKind kind, vec3 toEye) {
    return vec2(kind.halfWidth, kind.halfHeight * length(toEye.xz) + kind.halfWidth * abs(toEye.y));
}
