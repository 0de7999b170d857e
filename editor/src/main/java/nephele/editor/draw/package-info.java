/**
 * Draws a viewport with the engine: the level in each pane's view mode, followed through edits, and marks over it.
 * {@link nephele.editor.draw.ViewportDrawing} draws a {@link nephele.editor.draw.ViewportFrame}.
 */
package nephele.editor.draw;
