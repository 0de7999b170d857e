// One ball of a cloud: its optical depth in closed form, its light from the cells of the cloud. BEAM: sunlight of the beam only.
#include "cloud-pixel.glsl"
#include "puff-light.glsl"
#include "puff-sum.glsl"
#ifdef BEAM
#include "puff-beam.glsl"
#endif

flat in vec4 puff;
flat in float peak;
#ifndef BEAM
flat in vec2 depths;
#endif

struct Lit {
    float metres; // where the light that the eye sees of the ball is scattered, on the mean
    float toFront; // optical depth between there and the front of the ball
    float through; // of the cloud between front and back of the ball
};

const int SAMPLES = 4;

// The part of the ray in which a ball is lit.
vec2 litSpan(PuffPart part) {
    return clamp(part.span, -MOST_DEVIATIONS * puff.w, MOST_DEVIATIONS * puff.w);
}

// Balls overlap: what hides a part of one is the whole cloud there, as its cells have it.
Lit litPart(PuffPart part, vec3 ray) {
    vec2 span = litSpan(part);
    float stepMetres = (span.y - span.x) / float(SAMPLES);
    vec3 sums = vec3(1e-12 * vec2(part.nearest + span.x, 0.0), 1e-12);
    float depth = 0.0;
    for (int n = 0; n < SAMPLES; n++) {
        float along = span.x + (float(n) + 0.5) * stepMetres;
        vec3 place = (part.nearest + along) * ray;
        float inHalf = 0.5 * medium.x * stepMetres
            * cellDensity(textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0));
        depth += inHalf;
        float weight = exp(-0.5 * along * along / (puff.w * puff.w) - medium.y * depth);
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
#ifdef BEAM
    vec3 place = seen.metres * at.ray;
    vec3 radiance = beamRadiance(beamSeen(part, litSpan(part), puff.w, at.ray), at.ray) * irradiance
        + puffSky(place, lightAt(place, place.y).a);
#else
    float through = depths.x + max(seen.through, part.depth) + depths.y;
    PuffLight light = puffLight(seen.metres * at.ray, at.ray, depths.x + seen.toFront);
    vec3 radiance = puffRadiance(
        vec2(light.narrow, light.diffuse), light.sky, irradiance, through,
        vec2(narrowFading(at.ray), light.straight), medium.y);
#endif
    float covered = takenBy(part.depth);
    writeCloud(at, covered * radiance, covered, seen.metres);
}
