// The mixture of a terrain's layers. Twin: nephele.engine.level.terrain.TerrainLayers, which explains the weights. LAYERS
// is the number of layers, each material at its index. BAKED: their colours are mixed already.
// FROM_ABOVE: no slope is seen that has pictures from aside.
// PAINTED: a layer map replaces parts of the mixture.

uniform vec4 layerHeights[LAYERS]; // where the weight begins to rise and is 1, begins to fall and is 0, metres
uniform vec4 layerSlopes[LAYERS]; // by the upward component of the normal: where it falls from 1 and is 0, rises and is 1

struct GroundMaterial {
    vec3 baseColour;
    vec3 emission;
    vec3 normal; // unit, with the normal maps
    float roughness;
    float metallic;
};

float layerRise(float x, float zero, float one) {
    if (x >= one) {
        return 1.0;
    }
    float t = clamp((x - zero) / max(one - zero, 1e-20), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float layerFall(float x, float one, float zero) {
    return layerRise(-x, -zero, -one);
}

float layerWeight(int layer, float height, float up) {
#if LAYERS == 1
    return 1.0;
#endif
    vec4 h = layerHeights[layer];
    vec4 s = layerSlopes[layer];
    return layerRise(height, h.x, h.y) * layerFall(height, h.z, h.w) * layerFall(up, s.x, s.y)
            * layerRise(up, s.z, s.w);
}

#ifdef PAINTED
// Twin: nephele.engine.level.terrain.LayerPaint.
uniform sampler2D layerMap; // index of a layer, of 255, and its weight
uniform vec2 texelsPerMetre;

// Replaces weights, whose sum is 1, by what is painted at a place in metres from the terrain's origin.
void paintOver(inout float weights[LAYERS], vec2 place) {
    ivec2 last = textureSize(layerMap, 0) - 1;
    vec2 at = clamp(place * texelsPerMetre, vec2(0.0), vec2(last));
    ivec2 least = min(ivec2(at), last - 1);
    vec2 within = at - vec2(least);
    vec2 opposite = 1.0 - within;
    vec4 shares = vec4(opposite.x, within.x, opposite.x, within.x) * vec4(opposite.yy, within.yy);
    vec2 t00 = texelFetch(layerMap, least, 0).rg;
    vec2 t10 = texelFetch(layerMap, least + ivec2(1, 0), 0).rg;
    vec2 t01 = texelFetch(layerMap, least + ivec2(0, 1), 0).rg;
    vec2 t11 = texelFetch(layerMap, least + 1, 0).rg;
    vec4 painted = vec4(t00.g, t10.g, t01.g, t11.g);
    if (painted == vec4(0.0)) {
        return;
    }
    vec4 layers = round(255.0 * vec4(t00.r, t10.r, t01.r, t11.r));
    float kept = dot(shares, 1.0 - painted);
    painted *= shares;
    for (int i = 0; i < LAYERS; i++) {
        weights[i] = kept * weights[i] + dot(painted, vec4(equal(layers, vec4(float(i)))));
    }
}
#endif

#ifdef BAKED
uniform vec2 bakedPerMetre; // 1 / the terrain's sides
uniform sampler2DArray colours; // the mixture, seen from above
#elif defined(TEXTURED) || defined(NORMAL_MAP)
// The pictures of layers in three projections. Twin: nephele.engine.level.terrain.GroundProjections.
#define PICTURES
uniform vec3 layerOrigins[LAYERS]; // the terrain's origin in repeats of the layer's pictures
#ifdef TEXTURED
uniform sampler2DArray colours;
#endif
#ifdef NORMAL_MAP
uniform sampler2DArray normals;
#endif

const float LEAST_COMPONENT = java(level.terrain.GroundProjections.LEAST); // of the normal; a projection along an axis with a smaller one is not seen

// Returns the picture's coordinates of a place or of a change of place; the projection is along x, from above or along z.
vec2 projected(int axis, vec3 place, vec3 facing) {
    return axis == 1 ? place.xz : vec2(axis == 0 ? -facing.x * place.z : facing.z * place.x, -place.y);
}

vec3 alongGround(vec3 direction, vec3 n) {
    return normalize(direction - n * dot(n, direction));
}
#ifdef NORMAL_MAP
vec3 projectedNormal(vec3 texel, int axis, vec3 n, vec3 facing) {
    vec3 across = axis == 0 ? vec3(0.0, 0.0, -facing.x) : vec3(axis == 2 ? facing.z : 1.0, 0.0, 0.0);
    vec3 up = axis == 1 ? vec3(0.0, 0.0, -1.0) : vec3(0.0, 1.0, 0.0);
    return mappedNormal(texel, n, alongGround(across, n), alongGround(up, n));
}
#endif

#if defined(FROM_ABOVE) && LAYERS == 1
// Adds what the pictures give where only those from above are seen.
void addPictures(inout GroundMaterial sum, float weights[LAYERS], vec3 n, vec3 place) {
    Material material = materialAt(0.0);
    vec2 st = layerOrigins[0].xz + place.xz * (1.0 / material.layers.z);
#ifdef TEXTURED
    vec3 texel = texture(colours, vec3(st, max(material.layers.x, 0.0))).rgb;
    sum.baseColour = material.baseColourRoughness.rgb * (material.layers.x < 0.0 ? vec3(1.0) : texel);
#endif
#ifdef NORMAL_MAP
    vec4 detail = texture(normals, vec3(st, max(material.layers.y, 0.0)));
    bool isMapped = material.layers.y >= 0.0;
    sum.normal = isMapped ? projectedNormal(detail.rgb, 1, n, vec3(1.0)) : n;
    sum.roughness = material.baseColourRoughness.a * (isMapped ? detail.a : 1.0);
#endif
}
#else
// Adds what the pictures give. A loop over those that are seen takes one turn on flat ground of one layer, also on
// a processor that executes both branches of a condition; there, a condition at the loop's start would cost one more turn.
// Its turns differ between pixels, so it needs explicit derivatives.
void addPictures(inout GroundMaterial sum, float weights[LAYERS], vec3 n, vec3 place) {
#ifdef FROM_ABOVE
    const uint axes = 2u;
    const vec3 shares = vec3(0.0, 1.0, 0.0);
    const vec3 facing = vec3(1.0);
#else
    vec3 shares = max(abs(n) - LEAST_COMPONENT, 0.0);
    shares /= shares.x + shares.y + shares.z;
    uint axes = (shares.x > 0.0 ? 1u : 0u) | (shares.y > 0.0 ? 2u : 0u) | (shares.z > 0.0 ? 4u : 0u);
    vec3 facing = vec3(n.x < 0.0 ? -1.0 : 1.0, 1.0, n.z < 0.0 ? -1.0 : 1.0);
#endif
    uint seen = 0u;
    for (int i = 0; i < LAYERS; i++) {
        seen |= weights[i] > 0.0 ? axes << (3 * i) : 0u;
    }
    vec3 rightwards = dFdx(place);
    vec3 upwards = dFdy(place);
    uint rest = seen;
    do {
        int picture = max(findLSB(rest), 0);
        int layer = picture / 3;
#ifdef FROM_ABOVE
        const int axis = 1;
#else
        int axis = picture - 3 * layer;
#endif
        Material material = materialAt(float(layer));
        float perMetre = 1.0 / material.layers.z;
        vec2 st = projected(axis, layerOrigins[layer] + place * perMetre, facing);
        vec2 right = projected(axis, rightwards * perMetre, facing);
        vec2 up = projected(axis, upwards * perMetre, facing);
        float weight = weights[layer] * (axis == 0 ? shares.x : axis == 1 ? shares.y : shares.z);
#ifdef TEXTURED
        vec3 texel = textureGrad(colours, vec3(st, max(material.layers.x, 0.0)), right, up).rgb;
        sum.baseColour += weight * material.baseColourRoughness.rgb * (material.layers.x < 0.0 ? vec3(1.0) : texel);
#endif
#ifdef NORMAL_MAP
        vec4 detail = textureGrad(normals, vec3(st, max(material.layers.y, 0.0)), right, up);
        bool isMapped = material.layers.y >= 0.0;
        sum.normal += weight * (isMapped ? projectedNormal(detail.rgb, axis, n, facing) : n);
        sum.roughness += weight * material.baseColourRoughness.a * (isMapped ? detail.a : 1.0);
#endif
        rest &= rest - 1u;
    } while (rest != 0u);
}
#endif
#endif

// Returns the material at a place in metres from the terrain's origin, with the smooth normal n.
GroundMaterial groundAt(vec3 place, vec3 n) {
    float weights[LAYERS];
    float total = 0.0;
    for (int i = 0; i < LAYERS; i++) {
        weights[i] = layerWeight(i, place.y, n.y);
        total += weights[i];
    }
    for (int i = 0; i < LAYERS; i++) {
        weights[i] = total > 0.0 ? weights[i] / total : (i == 0 ? 1.0 : 0.0);
    }
#ifdef PAINTED
    paintOver(weights, place.xz);
#endif
    GroundMaterial sum = GroundMaterial(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 0.0);
    for (int i = 0; i < LAYERS; i++) {
        Material material = materialAt(float(i));
        sum.emission += weights[i] * material.emissionMetallic.rgb;
        sum.metallic += weights[i] * material.emissionMetallic.a;
#ifndef TEXTURED
        sum.baseColour += weights[i] * material.baseColourRoughness.rgb;
#endif
#ifndef NORMAL_MAP
        sum.roughness += weights[i] * material.baseColourRoughness.a;
#endif
    }
#ifdef BAKED
    sum.baseColour = texture(colours, vec3(place.xz * bakedPerMetre, 0.0)).rgb;
#endif
#ifdef PICTURES
    addPictures(sum, weights, n, place);
#endif
#ifdef NORMAL_MAP
    sum.normal = normalize(sum.normal);
#else
    sum.normal = n;
#endif
    return sum;
}
