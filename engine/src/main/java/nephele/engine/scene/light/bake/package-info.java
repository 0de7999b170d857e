/**
 * Baked light, read from files, and the bake of the sky visibility: for each light-map texel and model vertex, the
 * cosine-weighted share of the hemisphere that sees the sky. Faces are divided where they touch other solids, rays are traced within a budget, and results are
 * cached in a file.
 */
package nephele.engine.scene.light.bake;
