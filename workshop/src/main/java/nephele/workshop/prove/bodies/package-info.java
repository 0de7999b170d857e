/** Proofs for rigid bodies: piles, towers, falls, mass ratios and the balance of energy. */
package nephele.workshop.prove.bodies;
