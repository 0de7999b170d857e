/** Draws what light does not reach into depth maps, once for a static level, and hands the sky visibility over. */
package nephele.engine.render.pass.shadow;
