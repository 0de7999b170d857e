/** The tool that opens pairs of portals where the game's gun would. */
package nephele.editor.tool.portal;
