/** The tool that measures distances. */
package nephele.editor.tool.measure;
