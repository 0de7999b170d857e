/** How the session's thread waits for what takes long: a window goes on painting meanwhile. */
package nephele.editor.work;
