/** The tool that edits the vertices and edges of brushes. */
package nephele.editor.tool.vertex;
