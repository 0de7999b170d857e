/** Clouds as sheets whose columns are in a texture. */
package nephele.engine.render.pass.cloud.skyplane;
