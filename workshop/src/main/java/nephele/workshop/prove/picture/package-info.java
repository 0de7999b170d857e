/**
 * Proofs that compare drawn pictures with reference pictures or with exact geometry: portal views, mirrors, shadows,
 * culling.
 */
package nephele.workshop.prove.picture;
