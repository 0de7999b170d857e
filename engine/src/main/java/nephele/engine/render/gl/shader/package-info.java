/**
 * Shader programs: assembly of sources with includes, defines and constants of Java; linking; uniforms, declared by a
 * record; samplers and blocks, bound by their names ({@code TextureUnit}, {@code UniformBlock}). Compilation
 * errors name the file and line of the source before assembly.
 */
package nephele.engine.render.gl.shader;
