// The density of noise with a profile. Twin: nephele.engine.cloud.field.ProfiledNoise.
uniform sampler3D shapeTable;
uniform sampler3D detailTable;
uniform sampler2D profileTable; // by height: rise, billows, sharpness, body
uniform sampler2DArray planTable; // depth of columns inside of bodies, from -1 to 1, at the last and the next sampled
                                  // time; a layer for each box
uniform vec4 shapePlace; // xyz: the eye's place in periods, for the generation that fades; w: periods a metre
uniform vec4 detailPlace;
uniform vec3 shapeComing; // the same for the generation that comes
uniform vec3 detailComing;
uniform vec4 generations; // weights of the fading and the coming generation, of shape and of detail
uniform float eroding;

const float KNOTS = java(cloud.field.ProfiledNoise.KNOTS);
const float WISPS_TO = java(cloud.field.ProfiledNoise.WISPS_TO);

float evolved(sampler3D table, vec3 metres, vec4 fading, vec3 coming, vec2 weights) {
    float first = textureLod(table, fading.xyz + metres * fading.w, 0.0).r;
#ifdef EVOLVING
    float second = textureLod(table, coming + metres * fading.w, 0.0).r;
    return clamp(0.5 + weights.x * (first - 0.5) + weights.y * (second - 0.5), 0.0, 1.0);
#else
    return first;
#endif
}

float bodyDepth(vec3 place, float box) {
    vec2 depths = textureLod(planTable, vec3(acrossBox(place, box), box), 0.0).rg;
    return 2.0 * mix(depths.x, depths.y, cells.w) - 1.0;
}

// place: from the eye, its y a height over the planet's curve; box: what boxOf returns
float noiseDensity(vec3 place, vec2 box) {
    float height = clamp((place.y - cloudBase.y) / cloudHalf.y, 0.0, 1.0);
    vec4 profile = textureLod(profileTable, vec2((height * (KNOTS - 1.0) + 0.5) / KNOTS, 0.5), 0.0);
    float inside = 0.0;
    float share = 1.0;
    do {
        inside = mix(inside, bodyDepth(place, box.x), share);
        share = box.y;
        box = vec2(box.x + 1.0, 0.0);
    } while (share > 0.0);
    inside -= profile.r;
    if (inside <= 0.0) {
        return 0.0;
    }
    inside -= profile.g * (1.0 - evolved(shapeTable, place, shapePlace, shapeComing, generations.xy));
    if (inside <= 0.0) {
        return 0.0;
    }
    float detail = evolved(detailTable, place, detailPlace, detailComing, generations.zw);
    inside -= eroding * (1.0 - detail + min(1.0, height / WISPS_TO) * (2.0 * detail - 1.0));
    return profile.a * clamp(profile.b * inside, 0.0, 1.0);
}
