// The light model of OpenGL 2.1, section 2.14.1, for white lights without attenuation, white global ambient light and a
// viewer at infinity. In world directions. Java twin: FixedLight.

uniform samplerBuffer fixedLights; // three texels for each light
uniform vec3 towardsViewer; // unit
uniform vec4 lightTerms; // 1 or 0 for ambient, diffuse, specular, emissive

const int LIGHT_TEXELS = 3;

struct FixedMaterial {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;
    float shininess;
    int firstLight; // the first light of a chain; -1 for none
};

vec3 unitOrNothing(vec3 v) {
    float square = dot(v, v);
    return square > 0.0 ? v * inversesqrt(square) : vec3(0.0);
}

// Defines pow(0, 0) as 1.
float fixedPower(float base, float exponent) {
    return exponent == 0.0 ? 1.0 : base <= 0.0 ? 0.0 : pow(base, exponent);
}

// spot: unit direction and the cutoff's cosine, below -1 for a light in all directions.
float fixedSpotShare(vec3 towards, vec4 spot, float exponent) {
    float along = -dot(towards, spot.xyz);
    return spot.w < -1.0 ? 1.0 : along < spot.w ? 0.0 : fixedPower(along, exponent);
}

// place: position of a light and 1, or direction towards it and 0.
vec3 fixedLightShare(FixedMaterial m, vec3 point, vec3 normal, vec4 place, vec4 spot, float exponent) {
    vec3 towards = unitOrNothing(place.xyz - place.w * point);
    float facing = dot(normal, towards);
    if (facing <= 0.0) {
        return vec3(0.0);
    }
    vec3 halfway = unitOrNothing(towards + towardsViewer);
    float gloss = fixedPower(max(dot(normal, halfway), 0.0), m.shininess);
    vec3 reflected = lightTerms.y * facing * m.diffuse + lightTerms.z * gloss * m.specular;
    return fixedSpotShare(towards, spot, exponent) * reflected;
}

// normal: of unit length
vec3 fixedLit(FixedMaterial m, vec3 point, vec3 normal) {
    vec3 sum = lightTerms.x * m.ambient + lightTerms.w * m.emissive;
    for (int light = m.firstLight; light >= 0;) {
        vec4 place = texelFetch(fixedLights, LIGHT_TEXELS * light);
        vec4 spot = texelFetch(fixedLights, LIGHT_TEXELS * light + 1);
        vec2 exponentAndBefore = texelFetch(fixedLights, LIGHT_TEXELS * light + 2).xy;
        sum += fixedLightShare(m, point, normal, place, spot, exponentAndBefore.x);
        light = int(exponentAndBefore.y);
    }
    return clamp(sum, 0.0, 1.0);
}
