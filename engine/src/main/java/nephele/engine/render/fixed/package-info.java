/**
 * XML scenes as fixed-function OpenGL drew them: values as they are stored, without linear light, tone curve or dither.
 * {@link nephele.engine.render.fixed.FixedSceneDrawing} is what others use; no pass of a level's frame is in here.
 */
package nephele.engine.render.fixed;
