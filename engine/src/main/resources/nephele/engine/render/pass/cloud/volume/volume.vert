#include "frame.glsl"
#include "fullscreen.glsl"

#ifdef WHOLE
uniform vec2 layerReach; // the layer's pixels cover the view's and up to one more, so it reaches farther than 1
#endif

out vec3 direction; // not of unit length; its part along the view's axis is 1

void main() {
    vec2 corner = fullScreenCorner();
    vec2 place = corner;
#ifdef WHOLE
    place = (corner + 1.0) * layerReach - 1.0;
#endif
    direction = viewForward.xyz + place.x * viewRight.xyz + place.y * viewUp.xyz;
    gl_Position = vec4(corner, 0.0, 1.0);
}
