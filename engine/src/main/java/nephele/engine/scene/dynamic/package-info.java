/**
 * Dynamic objects without OpenGL: generated meshes of bodies and of the player's character, the character's pose, and
 * the copies of everything that reaches through portals.
 */
package nephele.engine.scene.dynamic;
