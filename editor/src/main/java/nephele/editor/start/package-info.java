/** Starts the editor: with a window, or for a script without one. */
package nephele.editor.start;
