/** The viewport as a Swing component: input, navigation, and the frame that the session makes. */
package nephele.editor.window.viewport;
