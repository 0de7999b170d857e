/**
 * Painting of terrains: what a brush does to heights, a stroke of it, and the files that strokes make beside a level.
 */
package nephele.editor.terrain;
