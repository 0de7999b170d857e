/** Everything that a user can start by name or key, tools included: commands, keys and their text, and search. */
package nephele.editor.command;
