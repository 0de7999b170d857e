#define MODEL
#define CURVED_RECEIVER
#include "output.glsl"
#include "materials.glsl"
#include "surface-light.glsl"
#include "covered-position.glsl"
#ifdef NORMAL_MAP
#include "normal-map.glsl"
#endif
#include "terrain-layers.glsl"
#ifdef SKY_AMBIENT
uniform sampler2D terrainSky;
#endif

uniform sampler2D terrainSlopes;
uniform vec2 cellMetres;

in vec2 fieldPosition;
in vec3 relativePosition;
#ifdef DETAIL
#include "terrain-surface.glsl"
#ifdef ANCHOR_POSITION
uniform vec3 originFromAnchor; // the terrain's origin, metres from the anchor
#endif
#else
in float height;
#ifdef ANCHOR_POSITION
in vec3 anchorPosition;
#endif
#endif

// Returns the smooth normal; twin: nephele.engine.math.heightfield.HeightFieldSurface.
vec3 smoothNormalAt(vec2 place) {
    vec2 rise = texture(terrainSlopes, (place + 0.5) / vec2(textureSize(terrainSlopes, 0))).rg;
    return normalize(vec3(-rise.x, 1.0, -rise.y));
}

#if defined(SKY_AMBIENT) || defined(BAKED_LIGHT)
// Returns a place in columns and rows as texture coordinates of a picture whose outer texels' centres lie on the border.
vec2 gridCoordinates(vec2 place, vec2 texels) {
    vec2 last = vec2(textureSize(terrainSlopes, 0) - 1);
    return (place / last * (texels - 1.0) + 0.5) / texels;
}
#endif

// Returns the normal of the drawn triangle.
vec3 triangleNormal() {
    vec3 n = normalize(cross(dFdx(relativePosition), dFdy(relativePosition)));
    return n.y < 0.0 ? -n : n;
}

void main() {
    vec3 n = smoothNormalAt(fieldPosition);
    vec2 onGround = fieldPosition * cellMetres;
#ifdef DETAIL
    GroundPoint point = groundPoint(fieldPosition, cellMetres);
    float height = point.height;
    vec3 faceNormal = normalize(vec3(-point.rise.x, 1.0, -point.rise.y));
#ifdef ANCHOR_POSITION
    vec3 anchorPosition = vec3(onGround.x, height, onGround.y) + originFromAnchor;
#endif
#else
    vec3 faceNormal = triangleNormal();
#endif
    GroundMaterial ground = groundAt(vec3(onGround.x, height, onGround.y), n);
    Surface s;
    s.baseColour = ground.baseColour;
    s.normal = ground.normal;
    s.smoothNormal = n;
    s.faceNormal = faceNormal;
#ifdef METALLIC_ROUGHNESS
    s.roughness = ground.roughness;
    s.toEye = -normalize(relativePosition);
#endif
#if defined(METALLIC_ROUGHNESS) || defined(ALL_DIFFUSE)
    s.metallic = ground.metallic;
#endif
#ifdef ANCHOR_POSITION
    s.anchorPosition = atCovered(anchorPosition, coveredOffset());
#endif
#ifdef SKY_AMBIENT
    s.skyVisibility = texture(terrainSky, gridCoordinates(fieldPosition, vec2(textureSize(terrainSky, 0)))).r;
#endif
#ifdef BAKED_LIGHT
    s.baked = bakedLightAt(gridCoordinates(fieldPosition, vec2(textureSize(bakedLight, 0).xy)));
#endif
    writeRadiance(surfaceRadiance(s) + ground.emission, relativePosition);
}
