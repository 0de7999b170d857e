/** Fills the openings of portals with what is seen through them. */
package nephele.engine.render.pass.portal;
