// Sunlight that goes along the beam up to a soft ball and is scattered towards the eye there.
// Twin: nephele.engine.cloud.light.BeamLight.

uniform vec4 beamLobes; // asymmetries of both lobes of the phase function, and the share of the second; fading of the beam

const int BEAM_STEPS = 4;

// Mean of exp(-t) for t between two numbers of at least 0, in either order.
float meanBetween(float from, float to) {
    float change = to - from;
    return abs(change) < 1e-2 ? exp(-0.5 * (from + to)) * (1.0 + change * change / 24.0) : (exp(-from) - exp(-to)) / change;
}

float beamFaded(vec3 place) {
    return beamLobes.w * lightAt(place, place.y).r;
}

// The share of the beam that is left where the eye sees a ball, on the mean: between the ends of a step, optical depths towards
// the eye and the sun change evenly. span: of the ray, metres from where it is nearest to the centre
float beamSeen(PuffPart part, vec2 span, float deviation, vec3 ray) {
    float stepMetres = (span.y - span.x) / float(BEAM_STEPS);
    float depth = 0.0;
    float faded = beamFaded((part.nearest + span.x) * ray);
    vec2 sums = vec2(0.0);
    for (int n = 0; n < BEAM_STEPS; n++) {
        float along = span.x + (float(n) + 0.5) * stepMetres;
        vec3 place = (part.nearest + along) * ray;
        float next = depth
            + medium.x * stepMetres * cellDensity(textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0));
        float fadedNext = beamFaded((part.nearest + along + 0.5 * stepMetres) * ray);
        float share = exp(-0.5 * along * along / (deviation * deviation));
        sums += share * vec2(meanBetween(depth + faded, next + fadedNext), meanBetween(depth, next));
        depth = next;
        faded = fadedNext;
    }
    return sums.x / sums.y;
}

// Radiance of an opaque ball per irradiance of the sun.
float beamRadiance(float seen, vec3 ray) {
    vec3 apart = ray - cloudSun;
    float separation = dot(apart, apart);
    float once = mix(henyeyGreenstein(beamLobes.x, separation), henyeyGreenstein(beamLobes.y, separation), beamLobes.z);
    return medium.z * once * seen;
}
