/**
 * Shader programs: assembly of sources with includes and defines, linking, uniforms, and texture units. Compilation
 * errors name the file and line of the source before assembly.
 */
package nephele.engine.render.gl.shader;
