/** The tool that cuts brushes by a plane. */
package nephele.editor.tool.clip;
