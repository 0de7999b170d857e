// One rigid part of a dynamic object; packed by nephele.engine.scene.dynamic.DynamicInstances.

uniform samplerBuffer dynamicInstances;

const int INSTANCE_TEXELS = java(scene.dynamic.DynamicInstances.FLOATS) / 4;
const float PARTS_STRIDE = java(scene.dynamic.DynamicMesh.PARTS_STRIDE);

vec4 instanceTexel(int instance, int texel) {
    return texelFetch(dynamicInstances, INSTANCE_TEXELS * instance + texel);
}

vec3 turned(vec4 quaternion, vec3 v) {
    return v + 2.0 * cross(quaternion.xyz, cross(quaternion.xyz, v) + quaternion.w * v);
}

vec3 turnedBack(vec4 quaternion, vec3 v) {
    return turned(vec4(-quaternion.xyz, quaternion.w), v);
}

// Returns the visible share of the sky for a face with this normal; the axes are weighted by the normal's squares
// (McTaggart 2004, "Half-Life 2 / Valve Source Shading").
float skySeen(int instance, vec3 n) {
    vec3 along = mix(instanceTexel(instance, 7).xyz, instanceTexel(instance, 6).xyz, step(0.0, n));
    return dot(n * n, along);
}

#ifdef BOUNCED_LIGHT
// Six texels an instance: the radiance around +x, +y, +z, -x, -y and -z.
uniform samplerBuffer bouncedLight;

// Returns the radiance of a white surface with this normal that only other surfaces light; weighted as skySeen.
vec3 bouncedOn(int instance, vec3 n) {
    int first = java(scene.dynamic.DynamicInstances.BOUNCED_FLOATS) / 4 * instance;
    ivec3 axis = first + ivec3(0, 1, 2) + ivec3(lessThan(n, vec3(0.0))) * 3;
    vec3 weights = n * n;
    return weights.x * texelFetch(bouncedLight, axis.x).rgb + weights.y * texelFetch(bouncedLight, axis.y).rgb
            + weights.z * texelFetch(bouncedLight, axis.z).rgb;
}
#endif
