/**
 * The bake of light: what the path tracer's rays gather at the texels of the light map, the vertices of models and the
 * points of terrains. Light between them is first balanced along few rays, then gathered once more along as many as its
 * error demands.
 */
package nephele.engine.bake;
