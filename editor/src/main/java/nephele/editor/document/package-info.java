/**
 * The edited level: its snapshots with selection, unlimited undo, drags that become one step, groups, hiding and
 * locking, and the clipboard's text; the bounds of its entities, rays through it, the grid, and how entities move, turn and
 * scale. Everything is an immutable value but {@link nephele.editor.document.Document} and what follows it.
 */
package nephele.editor.document;
