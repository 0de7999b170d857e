/**
 * The parts of a proof: a {@link nephele.workshop.prove.proof.Claim}, the figures that a batch measures and the bounds that they
 * must keep.
 */
package nephele.workshop.prove.proof;
