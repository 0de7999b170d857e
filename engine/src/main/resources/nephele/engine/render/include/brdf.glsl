// Metallic-roughness reflection: Lambert under GGX, height-correlated Smith, Schlick, lost energy returned after
// Turquin (2019). Sources, fits and bounds: nephele.engine.level.appearance.Brdf, its twin; compared in
// LightTwinsGlTest.

const float PI = 3.14159265;

struct Brdf {
    vec3 diffuse;
    vec3 f0;
    float alpha2;
    float nDotV;
    vec3 specularGain;
    vec3 ambientSpecular;
};

// Returns the inverse of the lobe's reflectance for f0 = 1 under equal light from all directions.
float inverseDirectionalAlbedo(float r, float mu) {
    float c0 = 1.0504262 + mu * (-0.5534067 + mu * (0.2685067 + mu * (0.7763794 - 0.5312025 * mu)));
    float c1 = 0.2777692 + mu * (3.6072694 + mu * (-4.3980971 + 1.2423761 * mu));
    float c2 = -0.9794563 + mu * (-4.7149996 + 1.3819016 * mu);
    float c3 = 1.0294144 + 5.1598502 * mu;
    return max(c0 + r * (c1 + r * (c2 + r * (c3 - 0.4033368 * r))), 1.0);
}

// Returns the part of that integral that is weighted with Schlick's (1 - v.h)^5.
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
    float inverse = inverseDirectionalAlbedo(r, mu);
    float all = 1.0 / inverse;
    float grazing = min(grazingAlbedo(r, mu), all);
    b.specularGain = 1.0 + b.f0 * (inverse - 1.0);
    b.ambientSpecular = (b.f0 * (all - grazing) + grazing) * b.specularGain;
    b.diffuse = max(baseColour * (1.0 - m) * (1.0 - b.ambientSpecular), 0.0);
    b.alpha2 = r * r * r * r;
    b.nDotV = mu;
    return b;
}

// Returns the reflected radiance per irradiance on a plane perpendicular to toLight; unit vectors.
vec3 reflectedLight(Brdf b, vec3 normal, vec3 toEye, vec3 toLight) {
    float nDotL = max(dot(normal, toLight), 0.0);
    vec3 halfway = toLight + toEye;
    halfway *= inversesqrt(max(dot(halfway, halfway), 1e-8));
    float nDotH = clamp(dot(normal, halfway), 0.0, 1.0);
    float vDotH = clamp(dot(toEye, halfway), 0.0, 1.0);
    // Lagrange's identity gives 1 - (n.h)^2 without the cancellation at the lobe's peak.
    vec3 sine = cross(normal, halfway);
    float d = max(dot(sine, sine) + nDotH * nDotH * b.alpha2, 1e-6);
    float distribution = b.alpha2 / (PI * d * d);
    float towardsEye = nDotL * sqrt(b.nDotV * b.nDotV * (1.0 - b.alpha2) + b.alpha2);
    float towardsLight = b.nDotV * sqrt(nDotL * nDotL * (1.0 - b.alpha2) + b.alpha2);
    float visibility = 0.5 / max(towardsEye + towardsLight, 1e-6);
    float s = 1.0 - vDotH;
    float s2 = s * s;
    vec3 fresnel = b.f0 + (1.0 - b.f0) * (s2 * s2 * s);
    return nDotL * (b.diffuse * (1.0 / PI) + fresnel * b.specularGain * (distribution * visibility));
}
