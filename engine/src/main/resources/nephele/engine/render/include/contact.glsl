// Contact shadow: the share of its ambient light that moving objects leave to a surface. A few spheres stand for them, packed by
// scene.dynamic.ContactCasters: always as many, since llvmpipe skips no branch and reads an array fast at constant indices only. Twin:
// scene.light.ContactShare in the root's src/test/java.

layout(std140) uniform Contact {
    vec4 contactSpheres[CONTACT_SPHERES]; // xyz: centre, metres from the anchor, w: radius
    vec4 contactOwners[CONTACT_SPHERES]; // x: 1 / 4 radii; yz: the object's first instance and the one after its last
};

// Returns the cosine-weighted share of the hemisphere that a sphere hides: (n.d) r^2 / d^2, and 0.04 more or less if it
// dips below the horizon (Quilez 2009, "Sphere Ambient Occlusion", has that case exactly).
float hiddenBySphere(vec4 sphere, float quarterOfInverse, vec3 position, vec3 n) {
    vec3 towards = sphere.xyz - position;
    float square = sphere.w * sphere.w;
    float inverse = inversesqrt(max(dot(towards, towards), square));
    float height = dot(towards, n);
    float above = max(height + sphere.w, 0.0);
    return (height > sphere.w ? height : above * above * quarterOfInverse) * square * inverse * inverse * inverse;
}

// Returns the share of ambient light that is left at a position from the anchor. `instance` is that of the surface, if it
// moves: its own object hides nothing.
float contactOpenShare(vec3 position, vec3 n, int instance) {
    float left = 1.0;
    for (int i = 0; i < CONTACT_SPHERES; i++) {
        float open = 1.0 - hiddenBySphere(contactSpheres[i], contactOwners[i].x, position, n);
#ifdef MOVING_RECEIVER
        bool isOwn = float(instance) >= contactOwners[i].y && float(instance) < contactOwners[i].z;
        open = isOwn ? 1.0 : open;
#endif
        left *= open;
    }
    return left;
}
