// The sky's irradiance / pi by the normal: Ramamoorthi and Hanrahan (2001). Twin: nephele.engine.scene.light.SkyIrradiance.
// Needs skyCoefficients, of light.glsl.

vec3 skyAmbient(vec3 n) {
    vec3 sum = skyCoefficients[0]
            + skyCoefficients[1] * n.y + skyCoefficients[2] * n.z + skyCoefficients[3] * n.x
            + skyCoefficients[4] * (n.x * n.y) + skyCoefficients[5] * (n.y * n.z)
            + skyCoefficients[6] * (3.0 * n.z * n.z - 1.0)
            + skyCoefficients[7] * (n.x * n.z) + skyCoefficients[8] * (n.x * n.x - n.y * n.y);
    return max(sum, 0.0);
}
