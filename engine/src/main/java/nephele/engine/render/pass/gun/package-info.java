/** Draws the portal gun in the player's hand before the main view of a player in first person. */
package nephele.engine.render.pass.gun;
