/**
 * The panels beside the views, all over one session: outliner, inspector, history, palette and problems, and the guide
 * through the first room.
 */
package nephele.editor.panel;
