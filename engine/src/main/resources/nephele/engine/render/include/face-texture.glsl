// Returns the direction of a texture's x on a face, as level.appearance.FaceTexture defines it.
vec3 textureAcross(vec3 n) {
    return normalize(abs(n.y) > 0.999 ? vec3(1.0, 0.0, 0.0) - n * n.x : cross(vec3(0.0, 1.0, 0.0), n));
}
