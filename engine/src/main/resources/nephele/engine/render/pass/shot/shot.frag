// The light of a shot: a bolt, or rings on a surface that takes no portal.
#include "output.glsl"
#include "displayed.glsl"
#include "shot-look.glsl"

in vec2 place;
in vec3 relativePosition;

uniform vec3 tint; // as displayed
uniform vec3 ageAndKind; // x: share of the duration, y: 1 for a shimmer, z: brightness

void main() {
    bool isShimmer = ageAndKind.y > 0.5;
    float opacity = isShimmer ? shimmerOpacity(length(place), ageAndKind.x) : boltOpacity(place.x, place.y, ageAndKind.x);
    float core = isShimmer ? 0.15 : smoothstep(0.45, 1.0, opacity);
    writeRadiance(radianceOf(mix(tint, vec3(1.0), 0.8 * core) * 1.4), relativePosition);
    pixel.a = clamp(opacity * ageAndKind.z, 0.0, 1.0);
}
