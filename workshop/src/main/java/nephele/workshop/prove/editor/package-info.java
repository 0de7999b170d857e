/** Long proofs about the editor, for {@code nephele prove}; the lab, which holds the others, knows no editor. */
package nephele.workshop.prove.editor;
