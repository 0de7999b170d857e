/** The editor's marks over the engine's picture: lines, areas, handles and labels in the world, without OpenGL. */
package nephele.editor.mark;
