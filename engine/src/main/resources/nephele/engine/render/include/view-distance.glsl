// Distances along a view's ray from the depth that its surfaces left.
#include "frame.glsl"

// Distance along the view's axis: recovers the projection's two numbers from its product with the rotation.
float axisMetres(float windowDepth) {
    vec3 third = vec3(clipFromRelative[0].z, clipFromRelative[1].z, clipFromRelative[2].z);
    return clipFromRelative[3].z / (2.0 * windowDepth - 1.0 - dot(third, viewForward.xyz));
}
