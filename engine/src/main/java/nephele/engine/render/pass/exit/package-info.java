/** Draws the curtains of light at a level's exits. */
package nephele.engine.render.pass.exit;
