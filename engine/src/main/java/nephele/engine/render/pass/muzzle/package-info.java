/** Lights the surfaces around the muzzle of the portal gun for a moment after a shot. */
package nephele.engine.render.pass.muzzle;
