/** The panes of the viewport without Swing and OpenGL: their cameras, arrangement, view modes and navigation. */
package nephele.editor.pane;
