/** Records that are added to a level, with what they need to be valid there. */
package nephele.editor.added;
