/** Proofs about terrains. */
package nephele.lab.prove.terrain;
