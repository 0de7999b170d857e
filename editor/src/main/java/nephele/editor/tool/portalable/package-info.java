/** The tool that decides which faces take portals. */
package nephele.editor.tool.portalable;
