/** The tool that draws brushes. */
package nephele.editor.tool.brush;
