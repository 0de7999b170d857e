// Metallic-roughness reflection: Lambert under GGX, height-correlated Smith, Schlick, energy returned after Turquin
// (2019). Sources, fits and bounds: nephele.engine.scene.light.Brdf, its twin; compared in BrdfGlTest.

const float PI = 3.14159265;

struct Brdf {
    vec3 diffuse;
    vec3 f0;
    float alpha2;
    float nDotV;
    vec3 specularGain;
    vec3 ambientSpecular;
};

// Reflectance of the lobe for f0 = 1 under equal light from everywhere.
float directionalAlbedo(float r, float mu) {
    float c0 = 0.9601870 + mu * (0.1653944 + mu * (0.1459566 - 0.2642402 * mu));
    float c1 = -0.2543877 + mu * (-0.7172698 + 0.9281141 * mu);
    float c2 = 0.7099345 - 0.9001942 * mu;
    return clamp(c0 + r * (c1 + r * (c2 - 0.4967762 * r)), 0.05, 1.0);
}

// The part of that integral that Schlick's (1 - v.h)^5 weighs.
float grazingAlbedo(float r, float mu) {
    float s = 1.0 - mu;
    float s3 = s * s * s;
    float low = 0.3827297 + r * (0.6488859 - 1.1300490 * r);
    float high = 0.7730444 + r * (-3.4834041 + 2.9353760 * r);
    return max(s3 * (low + s3 * high) - 0.0268499 * r, 0.0);
}

Brdf brdfOf(vec3 baseColour, float roughness, float metallic, float nDotV) {
    float r = clamp(roughness, 0.05, 1.0);
    float m = clamp(metallic, 0.0, 1.0);
    float mu = clamp(nDotV, 1e-3, 1.0);
    Brdf b;
    b.f0 = mix(vec3(0.04), baseColour, m);
    float all = directionalAlbedo(r, mu);
    float grazing = min(grazingAlbedo(r, mu), all);
    b.specularGain = 1.0 + b.f0 * (1.0 / all - 1.0);
    b.ambientSpecular = (b.f0 * (all - grazing) + grazing) * b.specularGain;
    b.diffuse = max(baseColour * (1.0 - m) * (1.0 - b.ambientSpecular), 0.0);
    b.alpha2 = r * r * r * r;
    b.nDotV = mu;
    return b;
}

// Reflected radiance per irradiance on a plane perpendicular to toLight; unit vectors.
vec3 reflectedLight(Brdf b, vec3 normal, vec3 toEye, vec3 toLight) {
    float nDotL = max(dot(normal, toLight), 0.0);
    vec3 halfway = toLight + toEye;
    halfway *= inversesqrt(max(dot(halfway, halfway), 1e-8));
    float nDotH = clamp(dot(normal, halfway), 0.0, 1.0);
    float vDotH = clamp(dot(toEye, halfway), 0.0, 1.0);
    float d = max(nDotH * nDotH * (b.alpha2 - 1.0) + 1.0, 1e-6);
    float distribution = b.alpha2 / (PI * d * d);
    float towardsEye = nDotL * sqrt(b.nDotV * b.nDotV * (1.0 - b.alpha2) + b.alpha2);
    float towardsLight = b.nDotV * sqrt(nDotL * nDotL * (1.0 - b.alpha2) + b.alpha2);
    float visibility = 0.5 / max(towardsEye + towardsLight, 1e-6);
    float s = 1.0 - vDotH;
    float s2 = s * s;
    vec3 fresnel = b.f0 + (1.0 - b.f0) * (s2 * s2 * s);
    return nDotL * (b.diffuse * (1.0 / PI) + fresnel * b.specularGain * (distribution * visibility));
}
