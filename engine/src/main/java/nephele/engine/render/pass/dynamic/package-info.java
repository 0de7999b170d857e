/**
 * Draws the dynamic objects: bodies and the player's character, with a copy on the other side of each portal that they
 * reach through.
 */
package nephele.engine.render.pass.dynamic;
