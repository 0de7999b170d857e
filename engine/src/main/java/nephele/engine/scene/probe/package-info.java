/**
 * The light on what has no place in the light map: moving things, billboards and particles. Rays look for the sky and,
 * where light was baked, for the light that static geometry sends back.
 */
package nephele.engine.scene.probe;
