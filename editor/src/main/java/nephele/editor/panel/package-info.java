/** The panels beside the views: outliner, inspector, history, palette and problems, all over one session. */
package nephele.editor.panel;
