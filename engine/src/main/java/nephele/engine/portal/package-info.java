/** Portals independent of rendering and physics: apertures, the rigid maps between them, and paths through them. */
package nephele.engine.portal;
