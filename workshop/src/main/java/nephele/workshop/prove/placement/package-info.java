/**
 * Proofs for portal placement: a shot's portal is placed where, and only where, a brute-force search finds room,
 * however the wall is divided.
 */
package nephele.workshop.prove.placement;
