/** Generators of the benchmark levels and of their camera paths. */
package nephele.workshop.art.bench;
