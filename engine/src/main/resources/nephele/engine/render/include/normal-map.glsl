// Tangent-space normals. Twin: nephele.engine.level.appearance.FaceTexture.

// texel: RGB of the normal map, 0 to 1; across and up: the directions in which the texture's u and v grow on the face.
vec3 mappedNormal(vec3 texel, vec3 faceNormal, vec3 across, vec3 up) {
    vec3 t = texel * 2.0 - 1.0;
    vec3 n = across * t.x + up * t.y + faceNormal * max(t.z, 0.1);
    return n * inversesqrt(max(dot(n, n), 1e-8));
}
