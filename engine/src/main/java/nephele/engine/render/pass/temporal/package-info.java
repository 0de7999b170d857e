/** Averages frames that see different points of each pixel. */
package nephele.engine.render.pass.temporal;
