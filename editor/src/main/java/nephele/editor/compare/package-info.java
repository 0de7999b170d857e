/** Two techniques of one cloud as the perspective pane's camera sees them, drawn by a thread with a context of its own. */
package nephele.editor.compare;
