// The mixture of a terrain's layers. Twin: nephele.engine.level.terrain.TerrainLayers, which explains the weights. LAYERS
// is the number of layers, each material at its index.

uniform vec4 layerHeights[LAYERS]; // where the weight begins to rise and is 1, begins to fall and is 0, metres
uniform vec4 layerSlopes[LAYERS]; // by the upward component of the normal: where it falls from 1 and is 0, rises and is 1
uniform vec2 layerOrigins[LAYERS]; // the picture's coordinates at the terrain's origin

struct GroundMaterial {
    vec3 baseColour;
    vec3 emission;
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

#ifdef TEXTURED
uniform sampler2DArray colours;

vec3 layerTexel(int layer, Material material, vec2 onGround) {
    vec2 st = layerOrigins[layer] + onGround / material.layers.z;
    // Read unconditionally, so that the derivatives exist.
    vec3 texel = texture(colours, vec3(st, max(material.layers.x, 0.0))).rgb;
    return material.layers.x < 0.0 ? vec3(1.0) : texel;
}
#endif

// Returns the material at a height above the terrain's origin, an upward component of the smooth normal and a place in
// metres from the origin along x and z.
GroundMaterial groundAt(float height, float up, vec2 onGround) {
    GroundMaterial sum = GroundMaterial(vec3(0.0), vec3(0.0), 0.0, 0.0);
    float total = 0.0;
    for (int i = 0; i < LAYERS; i++) {
        total += layerWeight(i, height, up);
    }
    for (int i = 0; i < LAYERS; i++) {
        Material material = materialAt(float(i));
        float weight = total > 0.0 ? layerWeight(i, height, up) / total : (i == 0 ? 1.0 : 0.0);
        vec3 colour = material.baseColourRoughness.rgb;
#ifdef TEXTURED
        colour *= layerTexel(i, material, onGround);
#endif
        sum.baseColour += weight * colour;
        sum.emission += weight * material.emissionMetallic.rgb;
        sum.roughness += weight * material.baseColourRoughness.a;
        sum.metallic += weight * material.emissionMetallic.a;
    }
    return sum;
}
