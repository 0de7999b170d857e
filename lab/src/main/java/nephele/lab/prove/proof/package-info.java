/**
 * The parts of a proof: a {@link nephele.lab.prove.proof.Claim}, the figures that a batch measures and the bounds that they
 * must keep.
 */
package nephele.lab.prove.proof;
