/**
 * The edited level: its snapshots with selection, unlimited undo, drags that become one step, groups, hiding and
 * locking, and the clipboard's text. Everything is an immutable value but {@link nephele.editor.document.Document}.
 */
package nephele.editor.document;
