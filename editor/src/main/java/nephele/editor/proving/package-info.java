/** Proofs about the open level beside the viewport: problems shown, heat map, solution, traced picture; without windows. */
package nephele.editor.proving;
