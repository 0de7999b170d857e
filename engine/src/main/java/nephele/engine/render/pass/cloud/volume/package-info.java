/** The technique {@code volume}: rays marched through the cells of a cloud. */
package nephele.engine.render.pass.cloud.volume;
