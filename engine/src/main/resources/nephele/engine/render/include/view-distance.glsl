// Distances along a view's ray from the depth that its surfaces left.
#include "frame.glsl"

// Distance along the view's axis: recovers the projection's two numbers from its product with the rotation. Of the sky, where
// the projection without a far plane divides by what is zero but for rounding, it is beyond everything.
float axisMetres(float windowDepth) {
    if (windowDepth >= 1.0) {
        return 1e30;
    }
    vec3 third = vec3(clipFromRelative[0].z, clipFromRelative[1].z, clipFromRelative[2].z);
    return clipFromRelative[3].z / (2.0 * windowDepth - 1.0 - dot(third, viewForward.xyz));
}
