/** Claims that only a full count can support: each proof runs in batches, can be resumed and leaves its figures in docs/proofs.md. */
package nephele.lab.prove;
