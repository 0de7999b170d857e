/**
 * The placement heat map: where on a level's surfaces the gun's portal fits, slides or is refused, and why. Without
 * Swing; {@link nephele.editor.heat.PlacementHeatMap} computes it in parts on any thread.
 */
package nephele.editor.heat;
