/** Portals without pictures or physics: apertures, the rigid maps between them, where they fit, and paths through them. */
package nephele.engine.portal;
