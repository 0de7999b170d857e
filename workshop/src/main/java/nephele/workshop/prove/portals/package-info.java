/** Proofs for motion through portals: bodies, players, eyes and rays cross without a jump, a leak or a gain. */
package nephele.workshop.prove.portals;
