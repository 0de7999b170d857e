/** Scales a picture that was drawn with fewer pixels up to the final one. */
package nephele.engine.render.pass.upscale;
