// A ball of extinction peak · exp(-d² / 2s²) at distance d of its centre. Twin: nephele.engine.cloud.field.GaussianPuff.

const float ROOT_2 = 1.41421356;
const float ROOT_HALF_PI = 1.25331414;
const float FAINTEST = java(cloud.drawn.CloudPuffs.Puff.FAINTEST); // optical depth from which on a ball ends
const float MOST_DEVIATIONS = 2.5; // from the centre up to which a ball is lit
const float CUT = java(cloud.field.GaussianPuff.CUT_DEVIATIONS); // deviations at which every ball ends

// Abramowitz and Stegun 1964, formula 7.1.26; the error is below 1.5e-7.
float errorFunction(float x) {
    float size = abs(x);
    float t = 1.0 / (1.0 + 0.3275911 * size);
    float tail = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
    return sign(x) * (1.0 - tail * exp(-size * size));
}

// The distance from the centre at which a ball ends.
float puffRadius(float deviation, float peak) {
    float depth = peak * deviation * 2.0 * ROOT_HALF_PI;
    return depth > FAINTEST ? deviation * min(CUT, sqrt(2.0 * log(depth / FAINTEST))) : 0.0;
}

struct PuffPart {
    float depth; // optical depth of a part of a ray
    float nearest; // distance at which the ray is nearest to the centre
    vec2 span; // of the part from there
};

PuffPart puffPart(vec3 centre, float deviation, float peak, vec3 ray, vec2 visible) {
    float nearest = dot(centre, ray);
    vec3 apart = centre - nearest * ray;
    float unit = ROOT_2 * deviation;
    float across = dot(apart, apart) / (unit * unit);
    float cut = CUT / ROOT_2;
    float halfLength = sqrt(max(0.0, cut * cut - across));
    float first = max((visible.x - nearest) / unit, -halfLength);
    float last = min((visible.y - nearest) / unit, halfLength);
    float depth = first < last
        ? peak * deviation * ROOT_HALF_PI * exp(-across) * (errorFunction(last) - errorFunction(first)) : 0.0;
    return PuffPart(depth, nearest, unit * vec2(first, last));
}
