/** The technique {@code volume}: rays marched through the cells of a cloud, over the finished surfaces of a view. */
package nephele.engine.render.pass.cloud.volume;
