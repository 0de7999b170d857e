// The colour, normal and depth of a plant from three views of its atlas; for a fragment shader.

const float VIEWS = java(scene.impostor.ImpostorAtlas.SIDE);
// Half of the border between views: filters must not reach the next one.
const float VIEW_EDGE = 0.016;

uniform sampler2DArray impostorColours; // times coverage
uniform sampler2DArray impostorShapes; // normal times coverage, and depth

in vec4 places01;
in vec2 places2;
in vec4 steps01;
in vec2 steps2;
flat in vec4 cells01;
flat in vec2 cells2;
flat in vec3 viewWeights;
flat in float atlasLayer;

const int STEPS = 2;

struct ImpostorTexel {
    vec4 colour; // times coverage, and coverage
    vec3 normal; // of the plant's frame, times coverage
    float depth; // towards the eye, in radii
};

vec3 atlasPlace(vec2 cell, vec2 place) {
    return vec3(cell + clamp(place, VIEW_EDGE, 1.0 - VIEW_EDGE) / VIEWS, atlasLayer);
}

void addView(vec2 cell, vec2 place, vec2 stepPerDepth, float weight, float lod, inout ImpostorTexel sum) {
    // Two steps of parallax: the ray meets the surface where the depth of its place is its own.
    float depth = 2.0 * textureLod(impostorShapes, atlasPlace(cell, place), lod).a - 1.0;
    for (int i = 1; i < STEPS; i++) {
        depth = 2.0 * textureLod(impostorShapes, atlasPlace(cell, place + stepPerDepth * depth), lod).a - 1.0;
    }
    vec3 at = atlasPlace(cell, place + stepPerDepth * depth);
    vec4 shape = 2.0 * textureLod(impostorShapes, at, lod) - 1.0;
    sum.colour += weight * textureLod(impostorColours, at, lod);
    sum.normal += weight * shape.xyz;
    sum.depth += weight * shape.a;
}

ImpostorTexel impostorTexel(float lod) {
    ImpostorTexel sum = ImpostorTexel(vec4(0.0), vec3(0.0), 0.0);
    addView(cells01.xy, places01.xy, steps01.xy, viewWeights.x, lod, sum);
    addView(cells01.zw, places01.zw, steps01.zw, viewWeights.y, lod, sum);
    addView(cells2, places2, steps2, viewWeights.z, lod, sum);
    return sum;
}
