/** Fills the openings of portals with the views through them. */
package nephele.engine.render.pass.portal;
