/** The tool that drags the sun across the sky. */
package nephele.editor.tool.sun;
