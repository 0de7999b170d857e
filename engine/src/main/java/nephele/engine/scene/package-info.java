/**
 * Data derived from a level for drawing, without OpenGL: geometry, views, visible sets, prepared light.
 *
 * <p>{@link nephele.engine.scene.Scene#of} derives once per level: {@link nephele.engine.scene.SolidGeometry} (a vertex
 * buffer each for solids and models, index batches in the order of the spatial index) and
 * {@link nephele.engine.scene.SceneMaterials} (textures merged into arrays). Per frame, a
 * {@link nephele.engine.scene.ViewTree} holds the views and {@link nephele.engine.scene.VisibleSet} the index ranges
 * that a view may see.
 */
package nephele.engine.scene;
