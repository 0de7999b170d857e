/**
 * Claims that only a full count can support. Each proof runs in batches, can be resumed and writes its figures to
 * docs/proofs.md.
 */
package nephele.workshop.prove;
