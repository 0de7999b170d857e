/** The editor at work without a window: document, file, panes, tool, grid, options and messages of one open level. */
package nephele.editor.session;
