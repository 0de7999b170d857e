/** The viewport as a Swing component: its surface with a drawing thread, input, navigation, and the session's frame. */
package nephele.editor.window.viewport;
