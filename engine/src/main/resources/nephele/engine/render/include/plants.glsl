// The numbers of models that are drawn as impostors; written by render.resource.PlantedScene.

// Two texels a plant: foot, metres from the anchor, and kind; size, turn about the vertical, radians, share of the sky that
// is seen, and place in the order in which far clusters lose plants, 0 to 1.
uniform samplerBuffer plants;
// Four texels a kind, see PlantKind.
uniform samplerBuffer plantKinds;
uniform samplerBuffer plantOrder; // four plants in each texel, -1 for none

struct Plant {
    vec3 foot;
    int kind;
    float scale;
    vec2 turn; // cosine and sine
    float sky;
    float rank;
};

struct PlantKind {
    vec3 centre; // of the upright cylinder around it, metres from the foot
    float halfWidth;
    float halfHeight;
    float radius; // of the sphere around it
    vec4 sky; // of KindSky
    vec3 emission;
};

int plantNumber(int place) {
    return int(texelFetch(plantOrder, place / 4)[place % 4]);
}

Plant plantAt(int number) {
    vec4 place = texelFetch(plants, 2 * number);
    vec4 look = texelFetch(plants, 2 * number + 1);
    return Plant(place.xyz, int(place.w), look.x, vec2(cos(look.y), sin(look.y)), look.z, look.w);
}

PlantKind plantKindAt(int number) {
    vec4 cylinder = texelFetch(plantKinds, 4 * number);
    vec4 sizes = texelFetch(plantKinds, 4 * number + 1);
    return PlantKind(cylinder.xyz, cylinder.w, sizes.x, sizes.y, texelFetch(plantKinds, 4 * number + 2),
        texelFetch(plantKinds, 4 * number + 3).rgb);
}

// Returns a direction of the plant's frame in the world.
vec3 turned(vec3 direction, vec2 turn) {
    return vec3(turn.x * direction.x + turn.y * direction.z, direction.y, turn.x * direction.z - turn.y * direction.x);
}

vec3 turnedBack(vec3 direction, vec2 turn) {
    return turned(direction, vec2(turn.x, -turn.y));
}
