/** Symbols of tools, actions and kinds of entities, drawn from lines, for the window and its panels. */
package nephele.editor.icon;
