// Draws a cloud from pictures that were baked around one point: what they show in the direction of the ray, wherever the eye
// is. Air, fog and mirrors are those of the view. Surfaces hide it if they are nearer than the mean distance of the cloud.
#include "cloud-pixel.glsl"

uniform sampler2DArray bakedFaces; // of each face: premultiplied radiance and coverage, then kilometres times coverage
uniform sampler2DArray bakedBefore;
uniform vec3 skyAxes[6]; // x, y and z of the faces, then of those before
uniform vec3 skyLayers[4]; // layers of the faces along the axes, and against them, then of those before; -1 without the cloud
uniform vec2 skyHalf[2]; // half the width and height of a face at distance 1
uniform vec4 skyWind[2]; // xyz: how far the wind has carried the cloud since it was baked; w: distance at which it is taken to
                         // be, 0 for the middle of a layer; metres
uniform vec3 skyLayer; // x: height of a layer's middle over the bake point; yz: planet of spanInside
uniform float fade; // weight of the faces, the rest is of those before

#ifdef PLACED
const float ENDLESS_KILOMETRES = 10000.0; // at which wind and steps of the eye are nothing: the layer before is looked up by direction
#endif

struct Baked {
    vec4 light;
    float kilometres; // times coverage
};

// The direction, of any length, in which that part of the cloud was which is now along a ray.
vec3 beforeTheWind(vec3 ray, vec4 wind) {
    float metres = wind.w;
    if (metres == 0.0) {
        float slope = spanSlope(ray, skyLayer.yz);
        float over = spanOver(skyLayer.x, skyLayer.yz);
        metres = over < 0.0 ? later(skyLayer.y, slope, over) : sooner(skyLayer.y, slope, over);
    }
    return metres * ray - wind.xyz;
}

// first: 0 for the faces, 1 for those before
Baked bakedAlong(vec3 seen, sampler2DArray faces, int first) {
    vec3 ray = beforeTheWind(seen, skyWind[first]);
    vec3 v = vec3(dot(skyAxes[3 * first], ray), dot(skyAxes[3 * first + 1], ray), dot(skyAxes[3 * first + 2], ray));
    vec3 size = abs(v);
    int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    float towards = v[axis] < 0.0 ? -1.0 : 1.0;
    float layer = skyLayers[2 * first + (v[axis] < 0.0 ? 1 : 0)][axis];
    vec2 across = axis == 0 ? vec2(towards * v.z, v.y) : axis == 1 ? vec2(towards * v.x, v.z) : vec2(-towards * v.x, v.y);
    vec2 place = across / (size[axis] * skyHalf[first]);
    if (layer < 0.0 || any(greaterThan(abs(place), vec2(1.0)))) {
        return Baked(vec4(0.0), 0.0);
    }
    place = 0.5 + 0.5 * place;
    return Baked(textureLod(faces, vec3(place, 2.0 * layer), 0.0), textureLod(faces, vec3(place, 2.0 * layer + 1.0), 0.0).r);
}

void main() {
    CloudPixel at = cloudPixel();
    Baked cloud = bakedAlong(at.ray, bakedFaces, 0);
    if (fade < 1.0) {
        Baked before = bakedAlong(at.ray, bakedBefore, 1);
        cloud = Baked(mix(before.light, cloud.light, fade), mix(before.kilometres, cloud.kilometres, fade));
    }
    float covered = cloud.light.a;
    float metres = 1000.0 * cloud.kilometres / max(covered, 1e-6);
    if (covered <= 0.0 || metres > at.visible.y) {
        discard;
    }
    writeCloud(at, cloud.light.rgb, covered, metres);
#ifdef PLACED
    place.r = covered * ENDLESS_KILOMETRES;
#endif
}
