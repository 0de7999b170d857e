// One rigid part of what moves; packed by nephele.engine.scene.thing.ThingCopies.

uniform samplerBuffer thingInstances;

const int INSTANCE_TEXELS = 6;
const float PARTS_STRIDE = 64.0;

vec4 instanceTexel(int instance, int texel) {
    return texelFetch(thingInstances, INSTANCE_TEXELS * instance + texel);
}

vec3 turned(vec4 quaternion, vec3 v) {
    return v + 2.0 * cross(quaternion.xyz, cross(quaternion.xyz, v) + quaternion.w * v);
}

vec3 turnedBack(vec4 quaternion, vec3 v) {
    return turned(vec4(-quaternion.xyz, quaternion.w), v);
}
