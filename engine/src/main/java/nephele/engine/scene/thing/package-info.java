/**
 * What moves, still without OpenGL: bodies and the player's figure as meshes made by code, how the figure stands, and
 * the copies of everything that reaches through portals.
 */
package nephele.engine.scene.thing;
