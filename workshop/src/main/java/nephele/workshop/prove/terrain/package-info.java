/** Proofs about terrains. */
package nephele.workshop.prove.terrain;
