/** The tool that gives faces a material. */
package nephele.editor.tool.paint;
