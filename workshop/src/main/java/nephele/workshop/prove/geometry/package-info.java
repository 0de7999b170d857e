/**
 * Proofs for geometric queries against brute force and exact arithmetic: rays, height fields, terrains, rotations, separations,
 * skin distances.
 */
package nephele.workshop.prove.geometry;
