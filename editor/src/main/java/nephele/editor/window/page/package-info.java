/** The settings of the editor as a page of a dialogue: look, files, and keys. */
package nephele.editor.window.page;
