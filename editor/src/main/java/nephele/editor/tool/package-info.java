/**
 * The tools of the viewport, without Swing: each turns pointer events into drags of the document and marks. A folder for
 * each tool; {@link nephele.editor.session.Tools#ALL} is the toolbar's order and the only registration.
 */
package nephele.editor.tool;
