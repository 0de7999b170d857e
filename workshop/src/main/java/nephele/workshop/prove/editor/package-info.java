/** Long proofs about the editor, for {@code nephele prove}, and the search for texts that are cut off in its pictures. */
package nephele.workshop.prove.editor;
