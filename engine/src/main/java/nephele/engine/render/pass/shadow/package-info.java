/** Draws the shadow maps, once for static geometry, and publishes the sky visibility. */
package nephele.engine.render.pass.shadow;
