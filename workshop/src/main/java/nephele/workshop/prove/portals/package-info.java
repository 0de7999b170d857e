/**
 * Proofs about portals: a shot's portal is placed where, and only where, a brute-force search finds room; bodies, players, eyes
 * and rays cross without a jump, a leak or a gain.
 */
package nephele.workshop.prove.portals;
