// The ray of a pixel of a layer, from the pixel's place alone, so that it is the same however many rays a frame marches.
#include "frame.glsl"
uniform vec2 layerStep; // of normalised device coordinates from pixel to pixel

// Not of unit length; its part along the view's axis is 1.
vec3 layerRay(vec2 place) {
    vec2 seen = place * layerStep - 1.0;
    return viewForward.xyz + seen.x * viewRight.xyz + seen.y * viewUp.xyz;
}
