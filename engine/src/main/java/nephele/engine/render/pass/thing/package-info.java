/** Draws what moves: bodies and the player's figure, on both sides of the portals that they reach through. */
package nephele.engine.render.pass.thing;
