#include "output.glsl"

in vec3 direction;

uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 ground;

// A gradient over the sine of the altitude; the Java twin is render.pass.sky.GradientSky.
void main() {
    float sine = direction.y * inversesqrt(dot(direction, direction));
    writeSky(mix(horizon, sine > 0.0 ? zenith : ground, abs(sine)), direction);
}
