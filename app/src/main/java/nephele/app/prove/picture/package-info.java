/** Proofs that compare drawn pictures with the exact twin's. */
package nephele.app.prove.picture;
