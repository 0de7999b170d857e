/** Commands, tools included, with their key bindings and the search over them. */
package nephele.editor.command;
