// Marches a ray through the cells of a cloud. Twin: nephele.engine.cloud.cells.CellMarch.
#include "cloud-span.glsl"
#include "cloud-light.glsl"

uniform vec4 cellEdges; // xyz: edges of a cell of the narrowest box; w: the shortest
uniform vec4 stepping; // cells of a step; place of the first sample in its step; the eye's height over a round planet; optical
                       // depth around the place where the view begins

const float GROWTH = java(cloud.cells.CellMarch.GROWTH); // metres of a step per metre of distance
const float FARTHEST = java(cloud.cells.DensityCells.FARTHEST); // distance that cloudDensity's 1 means, cells

// The part of a ray of unit direction in the cloud's boxes.
vec2 insideCloud(vec3 ray) {
    float widest = pow(WIDENING, cells.z - 1.0);
    vec2 planet = vec2(phase.z, stepping.z);
    vec2 inside = spanInside(ray, cloudBase, cloudHalf * vec3(widest, 1.0, widest), planet);
    return vec2(inside.x, min(inside.y, planetMetres(ray, planet)));
}

#ifdef NOISE
#include "cloud-noise.glsl"
#endif

float cellDensity(vec4 cell) {
#ifdef STEADY
    return cell.r;
#else
    return mix(cell.r, cell.a, cells.w);
#endif
}

#ifdef BY_FLASH
#include "cloud-flash.glsl"
#endif

// direction: of unit length; visible: the part of the ray in the cloud that no surface hides
CloudRay marchedCloud(vec3 direction, vec2 visible, float offset) {
    CloudRay ray = emptyRay();
#if !defined(BY_FLASH) && !defined(OF_BOLT)
    RayAngles angles = rayAngles(direction, stepping.w);
#endif
    vec2 planet = vec2(phase.z, stepping.z);
    float at = visible.x;
    float share = offset;
    while (at < visible.y && ray.scaled > OPAQUE) {
        float from;
        float to;
        float middle;
        vec3 place;
        float height;
        vec2 box;
        vec4 cell;
        float density;
        // A loop of its own, since a software renderer runs what follows for each sample, empty or not.
        do {
            float stepMetres = stepping.x * max(cellEdges.w, GROWTH * at);
            from = at;
            to = min(at + share * stepMetres, visible.y);
            middle = 0.5 * (from + to);
            place = middle * direction;
            height = heightAbove(direction, middle, planet);
            box = boxOf(place);
            cell = textureLod(cloudDensity, texelOf(place, height, box.x, cells.x), 0.0);
            at = to;
            share = 1.0;
            density = 0.0;
            if (cell.g * FARTHEST >= 1.0) {
                // Whole steps, so that the samples of neighbouring rays stay side by side.
                vec3 edges = cellEdges.xyz * vec3(1.0, 0.0, 1.0) * pow(WIDENING, box.x) + vec3(0.0, cellEdges.y, 0.0);
                vec3 perMetre = abs(direction) / edges;
                float emptyMetres = cell.g * FARTHEST / max(perMetre.x, max(perMetre.y, perMetre.z));
                at += stepMetres * max(0.0, floor(emptyMetres / stepMetres - 1.0));
            } else {
#ifdef NOISE
                density = noiseDensity(vec3(place.x, height, place.z), box);
#else
                density = cellDensity(cell);
                if (box.y > 0.0) {
                    vec4 wider = textureLod(cloudDensity, texelOf(place, height, box.x + 1.0, cells.x), 0.0);
                    density = mix(density, cellDensity(wider), box.y);
                }
#endif
            }
        } while (density <= 0.0 && at < visible.y);
        if (density <= 0.0) {
            break;
        }
        float depth = density * medium.x * (to - from);
#if defined(BY_FLASH)
        addFlashed(ray, middle * direction, density, depth, middle);
#elif defined(OF_BOLT)
        ray.transmittance *= exp(-depth);
        ray.scaled = ray.transmittance;
#else
        float mean = meanDepth(depth);
        float lit = from + mean / max(depth, 1e-20) * (to - from);
        vec4 light = lightAt(lit * direction, heightAbove(direction, lit, planet));
        addPart(ray, angles, depth, mean, light, cell.b, middle);
#endif
    }
#if defined(BY_FLASH)
    ray.metres /= max(1.0 - ray.scaled, 1e-6);
#elif !defined(OF_BOLT)
    endRay(ray);
#endif
    return ray;
}
