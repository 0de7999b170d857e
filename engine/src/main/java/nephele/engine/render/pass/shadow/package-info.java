/**
 * Draws the shadow maps and publishes the sky visibility. Maps of static geometry are drawn again only if their light
 * changes, maps of dynamic objects when these move. Shaders read them in {@code include/sun-shadow.glsl} and {@code
 * include/light-shadow.glsl}.
 */
package nephele.engine.render.pass.shadow;
