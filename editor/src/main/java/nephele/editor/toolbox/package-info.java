/** The list of all tools. */
package nephele.editor.toolbox;
