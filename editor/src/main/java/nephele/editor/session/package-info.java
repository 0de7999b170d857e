/**
 * The editor at work without a window: document, file, panes, tool, grid, options, settings and messages of one open
 * level; {@link nephele.editor.session.Tools#ALL} lists the tools.
 */
package nephele.editor.session;
