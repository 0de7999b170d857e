/**
 * The only raw OpenGL: context, programs, meshes, textures, targets, draw state and timers, each handle with one owner.
 *
 * <p>Everything starts with a {@link nephele.engine.render.gl.GlContext} ({@code offscreen()} or
 * {@code ofCurrent()}); objects take it first, carry a name for messages and are closed by whoever made them.
 * {@link nephele.engine.render.gl.DrawState} with its bindings is the only place that binds. OpenGL 4.1 core and GLSL 410.
 */
package nephele.engine.render.gl;
