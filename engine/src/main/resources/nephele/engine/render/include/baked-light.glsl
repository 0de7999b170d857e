// Light that was baked: of each sample of a surface the radiance that a white one sends, and the mean direction of the light that
// arrives. Twin: nephele.engine.scene.light.PackedLight. LIGHT_DIRECTIONS: the directions are read, where a normal differs from the
// surface's own. MIRRORED_LIGHT: glossy surfaces mirror less than they reflect diffusely: not what comes straight from sun and lamps; their
// layer is the last of LIGHT_LAYERS. MODEL_LIGHT: a sample for each vertex of a model's mesh, else a texture with radiance and directions in its layers.

#if defined(LIGHT_DIRECTIONS) && (defined(NORMAL_MAP) || defined(METALLIC_ROUGHNESS))
#define BAKED_DIRECTION
#endif
#if defined(MIRRORED_LIGHT) && defined(METALLIC_ROUGHNESS)
#define BAKED_MIRRORED
#endif

struct BakedLight {
    vec3 radiance;
#ifdef BAKED_DIRECTION
    vec3 direction; // |direction| <= 1
#endif
#ifdef BAKED_MIRRORED
    vec3 mirrored; // radiance
#endif
};

#ifdef MODEL_LIGHT
uniform usamplerBuffer modelLight;

// Returns three numbers with a common exponent.
vec3 unpacked(uint word) {
    return vec3(word & 511u, word >> 9 & 511u, word >> 18 & 511u) * exp2(float(word >> 27) - 24.0);
}

BakedLight bakedLightOfVertex(int vertex) {
    BakedLight light;
    light.radiance = unpacked(texelFetch(modelLight, LIGHT_LAYERS * vertex).r);
#ifdef BAKED_DIRECTION
    light.direction = 2.0 * unpacked(texelFetch(modelLight, LIGHT_LAYERS * vertex + 1).r) - 1.0;
#endif
#ifdef BAKED_MIRRORED
    light.mirrored = unpacked(texelFetch(modelLight, LIGHT_LAYERS * vertex + LIGHT_LAYERS - 1).r);
#endif
    return light;
}
#else
uniform sampler2DArray bakedLight;

BakedLight bakedLightAt(vec2 coordinates) {
    BakedLight light;
    light.radiance = texture(bakedLight, vec3(coordinates, 0.0)).rgb;
#ifdef BAKED_DIRECTION
    light.direction = 2.0 * texture(bakedLight, vec3(coordinates, 1.0)).rgb - 1.0;
#endif
#ifdef BAKED_MIRRORED
    light.mirrored = texture(bakedLight, vec3(coordinates, LIGHT_LAYERS - 1)).rgb;
#endif
    return light;
}
#endif

#ifdef BAKED_DIRECTION
// Returns the irradiance on a plane of a normal, 1 for the mean over all normals (Geomerics 2015, "Reconstructing Diffuse Lighting
// from Spherical Harmonic Data").
float relativeIrradiance(vec3 d, vec3 n) {
    float r = min(length(d), 1.0);
    float facing = r > 1e-4 ? dot(d, n) / r : 0.0;
    float p = 1.0 + 2.0 * r;
    float even = (1.0 - r) / (1.0 + r);
    return even + (1.0 - even) * (p + 1.0) * pow(max(0.5 + 0.5 * facing, 0.0), p);
}
#endif

// Returns how much more light a surface would get if it faced n instead of its own normal.
float gainFacing(BakedLight light, vec3 n, vec3 own) {
#ifdef BAKED_DIRECTION
    float ofOwn = max(relativeIrradiance(light.direction, own), java(scene.light.PackedLight.LEAST_OF_OWN_NORMAL));
    return relativeIrradiance(light.direction, n) / ofOwn;
#else
    return 1.0;
#endif
}

// Returns how much more light a glossy surface mirrors from around m than from all that its own normal faces. Light that is even over
// the half space above a surface has a mean direction of length 1/2: it has no less of it around m, though half of a plane that faces m is below it.
float gainMirrored(BakedLight light, vec3 m, vec3 own) {
#ifdef BAKED_DIRECTION
    return mix(1.0, gainFacing(light, m, own), clamp(4.0 * length(light.direction) - 2.0, 0.0, 1.0));
#else
    return 1.0;
#endif
}
