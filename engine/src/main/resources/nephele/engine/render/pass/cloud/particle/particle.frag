// One ball of a cloud: its optical depth in closed form, its light from the cells of the cloud.
#include "cloud-pixel.glsl"
#include "cloud-march.glsl"
#include "puff.glsl"

flat in vec4 puff;
flat in float peak;
flat in vec2 depths;

uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

// Sunlight per unit irradiance that the ball would send if it were opaque. Balls are blended by their true depth, though light
// that keeps near its direction goes on: so that the sum over a ray is right, each gets its share of what the whole ray has.
float sunlightOf(vec3 ray, vec4 light, float through, float toEye) {
    vec3 apart = ray - cloudSun;
    float separation = dot(apart, apart);
    float cosine = 1.0 - 0.5 * separation;
    float column = sqrt(sqrt(0.25 * separation)) * ((SEPARATIONS - 1.0) / SEPARATIONS) + 0.5 / SEPARATIONS;
    float taken = max(takenBy(through), 1e-8);
    // Towards the sun, depths from it and to the eye add up to the same all along the ray; elsewhere they grow, and the light
    // that keeps near its direction fades.
    float fading = max(1e-3, medium.y * (1.0 - cosine));
    float narrow = smallAngleLight(column, light.r + toEye) * takenBy(fading * through) / (fading * taken);
    float beam = exp(-medium.y * light.r);
    float resistance = 0.75 * (1.0 - phase.x) * medium.y;
    float toSun = 1.0 + resistance * OBLIQUITY * light.r;
    float toOutside = 1.0 + resistance * (stepping.w + toEye);
    float kept = min(1.0, BRIGHTEST * (toOutside + beam * toSun) / ((toOutside + toSun) * max(light.g, 1e-10)));
    float axisCosine = -dot(ray, diffuseAxis.xyz);
    float slope = cosine * clamp(diffuseAxis.w * beam, -light.g, light.g) + axisCosine * light.b;
    float once = (1.0 + 3.0 * phase.x * cosine) / FOUR_PI;
    float diffuse = medium.w * (once * beam + kept * max(0.0, light.g + phase.x * slope));
    return max(0.0, narrow + takenBy(medium.y * through) / taken * diffuse);
}

struct Lit {
    float metres; // where the light that the eye sees of the ball is scattered, on the mean
    float toFront; // optical depth between there and the front of the ball
    float through; // of the cloud between front and back of the ball
};

const int SAMPLES = 6;

// Balls overlap: what hides a part of one is the whole cloud there, as its cells have it.
Lit litPart(PuffPart part, vec3 ray) {
    vec2 span = clamp(part.span, -MOST_DEVIATIONS * puff.w, MOST_DEVIATIONS * puff.w);
    float stepMetres = (span.y - span.x) / float(SAMPLES);
    vec3 sums = vec3(1e-12 * vec2(part.nearest + span.x, 0.0), 1e-12);
    float depth = 0.0;
    for (int n = 0; n < SAMPLES; n++) {
        float along = span.x + (float(n) + 0.5) * stepMetres;
        vec3 place = (part.nearest + along) * ray;
        float inHalf = 0.5 * medium.x * stepMetres
            * cellDensity(textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0));
        depth += inHalf;
        float weight = exp(-0.5 * along * along / (puff.w * puff.w) - depth);
        sums += weight * vec3(part.nearest + along, depth, 1.0);
        depth += inHalf;
    }
    return Lit(sums.x / sums.z, sums.y / sums.z, depth);
}

void main() {
    CloudPixel at = cloudPixel();
    PuffPart part = puffPart(puff.xyz, puff.w, peak, at.ray, at.visible);
    if (part.depth < 1e-7) {
        discard;
    }
    Lit seen = litPart(part, at.ray);
    vec3 lit = seen.metres * at.ray;
    vec4 light = lightAt(lit, lit.y);
    float left = textureLod(cloudDensity, texelOf(lit, lit.y, 0.0, cells.x), 0.0).b;
    float through = depths.x + max(seen.through, part.depth) + depths.y;
    vec3 radiance = sunlightOf(at.ray, light, through, depths.x + seen.toFront) * irradiance
        + medium.z * (light.a * skyAbove + max(0.0, left - light.a) * skyBelow);
    float covered = takenBy(part.depth);
    writeCloud(at, covered * radiance, covered, seen.metres);
}
