/** Clouds as sheets of octaves of noise. */
package nephele.engine.render.pass.cloud.procedural;
