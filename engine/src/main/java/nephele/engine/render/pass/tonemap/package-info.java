/** Tone-maps the linear picture of output HDR into the final 8-bit one. */
package nephele.engine.render.pass.tonemap;
