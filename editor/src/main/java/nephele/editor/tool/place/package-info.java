/** The tool that places a new entity of any kind on a surface. */
package nephele.editor.tool.place;
