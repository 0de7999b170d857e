/** The tool that paints the heights of terrains. */
package nephele.editor.tool.terrain;
