// Completes a layer of clouds of which this frame has marched one ray in each square: the others show the layer before,
// at the place where their part of the cloud was seen then.
layout(location = 0) out vec4 pixel;

#include "layer-ray.glsl"
#include "finite.glsl"

uniform sampler2D fresh; // premultiplied radiance and coverage of the marched rays
uniform sampler2D freshPlaces; // times coverage: r: kilometres to the cloud; gb: the wind's motion along the view's axes since
                               // the layer before, metres; a: coverage
uniform sampler2D before;
uniform vec3 square; // x: its side; y, z: column and row of the marched ray in it
uniform vec3 beforeRight; // divided by the tangent of half the field of view, as beforeUp is
uniform vec3 beforeUp;
uniform vec3 beforeForward;
uniform vec3 moved; // from the eye before to this one, metres
uniform float nearestKilometres; // to the bounds of the nearest cloud
uniform vec3 movedPast; // from the eye before to this one, in the space that drifts with that cloud, metres
uniform vec2 halfLayer; // pixels from the middle of the view to its sides

const float SKY_KILOMETRES = java(render.pass.cloud.CloudLayer.SKY_KILOMETRES); // where no cloud tells how far it is
const float STILL = 1.0 / 64.0; // pixels
const float TRUSTED = 0.1; // motion of the cloud between two frames, by parallax and wind, pixels
const float UNKNOWN = -1.0; // coverage of what was not seen before

vec2 pixelBefore(vec3 place) {
    float along = dot(place, beforeForward);
    vec2 seen = vec2(dot(place, beforeRight), dot(place, beforeUp)) / along;
    return along > 0.0 ? (seen + 1.0) * halfLayer : vec2(-1.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int side = int(square.x);
    ivec2 last = textureSize(fresh, 0) - 1;
    ivec2 offset = at - ivec2(square.yz) + side;
    ivec2 within = offset % side;
    ivec2 low = clamp(offset / side - 1, ivec2(0), last);
    if (within == ivec2(0)) {
        pixel = finite(texelFetch(fresh, low, 0), vec4(0.0));
        return;
    }
    vec4 place = texelFetch(freshPlaces, low, 0);
    vec3 seenThere = place.a > 1e-3 ? place.rgb / place.a : vec3(SKY_KILOMETRES, 0.0, 0.0);
    vec3 blown = seenThere.y * normalize(viewRight.xyz) + seenThere.z * normalize(viewUp.xyz);
    vec3 ray = normalize(layerRay(gl_FragCoord.xy));
    vec2 was = pixelBefore(ray * (1000.0 * seenThere.x) + moved - blown);
    bool isSeen = all(greaterThanEqual(was, vec2(0.0))) && all(lessThanEqual(was, 2.0 * halfLayer));
    bool isStill = distance(was, gl_FragCoord.xy) < STILL;
    vec4 seen = vec4(UNKNOWN);
    if (isSeen) {
        seen = isStill ? texelFetch(before, at, 0) : texture(before, was / vec2(textureSize(before, 0)));
        seen = finite(seen, vec4(UNKNOWN));
    }
    // What was seen before may have been nearer than what is seen now.
    vec2 here = pixelBefore(ray);
    float nearest = 1000.0 * nearestKilometres;
    float motion = max(distance(was, here), distance(pixelBefore(ray * nearest + movedPast), here));
    if (seen.a != UNKNOWN && motion <= TRUSTED) {
        pixel = seen;
        return;
    }
    // A place that is wrong because the cloud is near must not show something else than the rays around.
    ivec2 high = min(offset / side, last);
    vec4 a = finite(texelFetch(fresh, low, 0), vec4(0.0));
    vec4 b = finite(texelFetch(fresh, ivec2(high.x, low.y), 0), a);
    vec4 c = finite(texelFetch(fresh, ivec2(low.x, high.y), 0), a);
    vec4 d = finite(texelFetch(fresh, high, 0), a);
    vec2 share = vec2(within) / square.x;
    vec4 even = mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
    vec4 least = min(min(a, b), min(c, d));
    vec4 most = max(max(a, b), max(c, d));
    vec4 margin = 0.25 * (most - least);
    pixel = seen.a == UNKNOWN
        ? even
        : mix(seen, clamp(seen, least - margin, most + margin), smoothstep(TRUSTED, 1.0, motion));
}
