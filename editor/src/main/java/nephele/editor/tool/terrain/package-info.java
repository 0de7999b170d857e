/** The tool that paints the heights and layers of terrains. */
package nephele.editor.tool.terrain;
