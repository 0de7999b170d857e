/**
 * Proofs that {@code engine.cloud} computes radiative transfer without bias, against tables of slabs and pictures of
 * another renderer, and that the sky of an atmosphere changes without jumps. The tables and pictures are resources of this package.
 */
package nephele.workshop.prove.cloud;
