/**
 * The panes of the viewport without Swing and OpenGL: their cameras, arrangement, view modes and navigation, and the
 * marks over their pictures.
 */
package nephele.editor.pane;
