// A cloud as a sheet at the middle of its heights. Where a ray meets it the column above and below is read, and counts as
// even from the cloud's base to its top: the optical depth of the ray is that of the column divided by the cosine, and ends
// where a curved layer does. Its light is that of a march of two steps. Twin of the mesh: CurvedMesh in the tests.
#include "cloud-span.glsl"
#include "cloud-light.glsl"

uniform vec2 sheet; // x: height of the eye over a round planet; y: longest way through the cloud, metres

const int SHEET_STEPS = 2; // of the march through a column
const float FARTHEST_SHEET = 1e7; // metres

// A part of a ray in the cloud: what it passes of a column.
struct SheetPart {
    float metres; // to the place on the sheet
    float passed; // length of the way through the cloud, metres
    vec2 heights; // where that begins and ends, from 0 at the base to 1 at the top
};

// mean density of the column, and its product with the mean height and the mean square of the height, 0 to 1
vec3 columnAt(vec3 place, SheetPart part);

// The heights between which an even column has these moments.
vec2 columnSpan(vec3 column) {
    float mean = column.y / column.x;
    float reach = sqrt(3.0 * max(0.0, column.z / column.x - mean * mean));
    return clamp(vec2(mean - reach, mean + reach), 0.0, 1.0);
}

void addSheet(inout CloudRay ray, RayAngles angles, vec3 direction, SheetPart part) {
    vec3 place = part.metres * direction;
    vec2 apart = abs(place.xz - cloudBase.xz);
    bool isFinite = cells.z == 1.0; // that of a layer goes on with the columns at the sides of the widest box
    if (isFinite && any(greaterThan(apart, cloudHalf.xz))) {
        return;
    }
    vec3 column = columnAt(place, part);
    float depth = column.x * medium.x * min(part.passed, sheet.y);
    if (!(depth > 0.0)) {
        return;
    }
    vec2 span = columnSpan(column);
    float box = boxOf(place).x;
    float stepDepth = depth / float(SHEET_STEPS);
    float mean = meanDepth(stepDepth);
    for (int n = 0; n < SHEET_STEPS; n++) {
        float lit = mix(part.heights.x, part.heights.y, (float(n) + mean / max(stepDepth, 1e-20)) / float(SHEET_STEPS));
        float height = cloudBase.y + cloudHalf.y * mix(span.x, span.y, lit);
        vec4 cell = textureLod(cloudDensity, texelOf(place, height, box, cells.x), 0.0);
        vec4 light = lightAt(place, height);
        addPart(ray, angles, stepDepth, mean, light, max(cell.b, light.a), part.metres);
    }
}

// Where a part of a ray that rises, or falls, throughout is nearest to the sheet.
float nearestToSheet(vec3 ray, vec2 part, bool rises, vec2 planet) {
    float bend = planet.x;
    float slope = spanSlope(ray, planet);
    float over = spanOver(cloudBase.y + 0.5 * cloudHalf.y, planet);
    float at = sooner(bend, slope, over);
    if (rises) {
        at = over <= 0.0 ? later(bend, slope, over)
            : bend > 0.0 ? (-slope + sqrt(max(0.0, slope * slope - 4.0 * bend * over))) / (2.0 * bend) : 0.0;
    }
    return clamp(at, part.x, part.y);
}

SheetPart sheetPart(vec3 ray, vec2 part, bool rises, vec2 planet) {
    vec2 heights = vec2(heightAbove(ray, part.x, planet), heightAbove(ray, part.y, planet));
    return SheetPart(nearestToSheet(ray, part, rises, planet), part.y - part.x,
        clamp((heights - cloudBase.y) / cloudHalf.y, 0.0, 1.0));
}

// A sheet around the planet, or a flat one. A ray that falls past the planet and rises again meets it twice.
void addShell(inout CloudRay ray, RayAngles angles, vec3 direction, vec2 visible, vec2 planet) {
    float slope = spanSlope(direction, planet);
    vec2 inside = betweenHeights(
        planet.x, slope, spanOver(cloudBase.y, planet), spanOver(cloudBase.y + cloudHalf.y, planet));
    inside = vec2(max(inside.x, visible.x),
        min(min(inside.y, FARTHEST_SHEET), min(visible.y, planetMetres(direction, planet))));
    if (!(inside.x < inside.y)) {
        return;
    }
    float lowest = planet.x > 0.0 ? -slope / (2.0 * planet.x) : slope < 0.0 ? NEVER : 0.0;
    float turn = clamp(lowest, inside.x, inside.y);
    if (turn > inside.x) {
        addSheet(ray, angles, direction, sheetPart(direction, vec2(inside.x, turn), false, planet));
    }
    if (turn < inside.y) {
        addSheet(ray, angles, direction, sheetPart(direction, vec2(turn, inside.y), true, planet));
    }
}

#ifdef SHEET_CURVED
const float MESH_DIVISIONS = 16.0;
const float MESH_CURVE = 9.0; // radius by whose square the mesh sinks, in heights of its middle over the eye
const float MESH_HALF = 8.94427191; // sqrt(80)

float meshHeight(vec2 place) {
    return 1.0 - dot(place, place) / MESH_CURVE;
}

// xyz: height, and its slopes along x and z, of the plane of the mesh's triangle at a place; in heights of its middle
vec3 meshPlane(vec2 place) {
    float edge = 2.0 * MESH_HALF / MESH_DIVISIONS;
    vec2 corner = clamp(floor(place / edge), -0.5 * MESH_DIVISIONS, 0.5 * MESH_DIVISIONS - 1.0);
    vec2 low = corner * edge;
    vec2 within = place / edge - corner;
    vec2 far = low + edge;
    float first = meshHeight(low);
    float last = meshHeight(far);
    float side = meshHeight(within.x > within.y ? vec2(far.x, low.y) : vec2(low.x, far.y));
    vec2 slopes = (within.x > within.y ? vec2(side - first, last - side) : vec2(last - side, side - first)) / edge;
    return vec3(first - dot(slopes, low), slopes);
}

// The sheet of (16 + 1)² vertices that hangs around the eye: it sinks by the square of the distance.
void addMesh(inout CloudRay ray, RayAngles angles, vec3 direction, vec2 visible) {
    float middle = cloudBase.y + 0.5 * cloudHalf.y;
    vec3 towards = vec3(direction.x, middle < 0.0 ? -direction.y : direction.y, direction.z);
    float a = dot(towards.xz, towards.xz) / MESH_CURVE;
    float t = 2.0 / max(towards.y + sqrt(towards.y * towards.y + 4.0 * a), 1e-6);
    vec3 plane = vec3(1.0, 0.0, 0.0);
    float facing = 1.0;
    for (int n = 0; n < 3; n++) {
        plane = meshPlane(t * towards.xz);
        facing = towards.y - dot(plane.yz, towards.xz);
        t = plane.x / max(facing, 1e-6);
    }
    float metres = t * abs(middle);
    float cosine = max(facing, 1e-6) * inversesqrt(1.0 + dot(plane.yz, plane.yz));
    bool isOnMesh = t > 0.0 && all(lessThanEqual(abs(t * towards.xz), vec2(MESH_HALF)));
    if (isOnMesh && metres > visible.x && metres < visible.y) {
        vec2 heights = middle < 0.0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
        addSheet(ray, angles, direction, SheetPart(metres, cloudHalf.y / cosine, heights));
    }
}
#endif

#ifdef SHEET_DOME
// A hemisphere around the eye that touches the sheet.
void addDome(inout CloudRay ray, RayAngles angles, vec3 direction, vec2 visible) {
    float middle = cloudBase.y + 0.5 * cloudHalf.y;
    float metres = abs(middle);
    if (direction.y * middle > 0.0 && metres > visible.x && metres < visible.y) {
        vec2 heights = middle < 0.0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
        addSheet(ray, angles, direction, SheetPart(metres, cloudHalf.y, heights));
    }
}
#endif

// direction: of unit length; visible: the part of the ray that no surface hides
CloudRay throughSheet(vec3 direction, vec2 visible) {
    CloudRay ray = emptyRay();
    RayAngles angles = rayAngles(direction, 0.0);
#if defined(SHEET_CURVED) || defined(SHEET_DOME)
    bool isLayer = cells.z > 1.0;
    if (isLayer) {
#ifdef SHEET_CURVED
        addMesh(ray, angles, direction, visible);
#else
        addDome(ray, angles, direction, visible);
#endif
    } else {
        addShell(ray, angles, direction, visible, vec2(0.0));
    }
#elif defined(SHEET_FLAT)
    addShell(ray, angles, direction, visible, vec2(0.0));
#else
    addShell(ray, angles, direction, visible, vec2(phase.z, sheet.x));
#endif
    ray.metres /= max(1.0 - ray.transmittance, 1e-6);
    ray.sunlight = max(0.0, ray.sunlight);
    return ray;
}
