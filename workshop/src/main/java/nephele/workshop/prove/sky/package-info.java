/** Proofs about the sky of an atmosphere: it changes without jumps while the sun moves. */
package nephele.workshop.prove.sky;
