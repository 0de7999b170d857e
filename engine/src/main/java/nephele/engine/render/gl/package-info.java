/**
 * The only raw OpenGL: context, programs, meshes, textures, targets, draw state and timers, each handle with one owner.
 *
 * <p>A {@link nephele.engine.render.gl.GlContext} ({@code offscreen()} or {@code ofCurrent()}) is the first argument of
 * every object; objects have a name for messages, and their creator closes them. Only {@link
 * nephele.engine.render.gl.DrawState} and its bindings bind objects. OpenGL 4.1 core and GLSL 410.
 */
package nephele.engine.render.gl;
