/** Geometry of brushes for editing: pure functions from solids of a level to other solids, or to why not. */
package nephele.editor.brush;
