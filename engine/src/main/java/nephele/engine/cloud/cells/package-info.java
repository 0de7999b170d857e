/**
 * Clouds sampled in cells, which the march of a ray looks up: {@link nephele.engine.cloud.cells.DensityCells} and {@link
 * nephele.engine.cloud.cells.LightCells}. {@link nephele.engine.cloud.cells.CellMarch} is the shader's twin.
 */
package nephele.engine.cloud.cells;
