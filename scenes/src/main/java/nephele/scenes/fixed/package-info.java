/**
 * XML scenes as fixed-function OpenGL drew them: values as they are stored, without linear light, tone curve or dither.
 * {@link nephele.scenes.fixed.FixedSceneDrawing} is the entry point; no pass of a level's frame is in this
 * package.
 */
package nephele.scenes.fixed;
