/** Pictures of parts of the editor without a display, and the search for texts in them that are cut off. */
package nephele.workshop.prove.editor.picture;
