/**
 * What is derived from a level to draw it, still without OpenGL: geometry, views, visible sets, prepared light.
 *
 * <p>{@link nephele.engine.scene.Scene#of} derives once per level: {@link nephele.engine.scene.SolidGeometry} (one
 * vertex buffer, index batches in the order of the spatial index) and {@link nephele.engine.scene.SceneMaterials}
 * (textures merged into arrays). {@link nephele.engine.scene.View} is a value; per frame
 * {@link nephele.engine.scene.VisibleSet} holds the index ranges that a view can see.
 */
package nephele.engine.scene;
