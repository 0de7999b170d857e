/** Picking: the shapes and bounds of a level's entities, ray queries against them, and snapping to a grid. */
package nephele.editor.pick;
