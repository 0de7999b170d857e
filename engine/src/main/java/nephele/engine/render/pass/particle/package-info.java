/** Draws the particles of emitters as squares that face the eye, blended from the farthest to the nearest. */
package nephele.engine.render.pass.particle;
