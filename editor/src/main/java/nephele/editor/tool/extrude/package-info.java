/** The tool that extrudes faces. */
package nephele.editor.tool.extrude;
