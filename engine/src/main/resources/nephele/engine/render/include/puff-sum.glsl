// The light of a ball as it is blended. Balls are blended by their true depth, though light that keeps near its direction
// goes on: so that the sum over a ray is right, each ball gets its share of what the whole ray has.

// Radiance of an opaque ball. through: optical depth of the cloud on the whole ray; fading: of narrow light, and the depth on
// which it can lie; scale: scaled divided by true depth
vec3 puffRadiance(vec2 sun, vec3 sky, vec3 irradiance, float through, vec2 fading, float scale) {
    float taken = max(takenBy(through), 1e-8);
    float narrow = sun.x * takenBy(fading.x * min(through, fading.y)) / (fading.x * taken);
    return max(0.0, narrow + takenBy(scale * through) / taken * sun.y) * irradiance + sky;
}
