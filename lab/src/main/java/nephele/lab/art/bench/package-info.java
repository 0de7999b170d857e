/** Generators of the benchmark levels and of their camera paths. */
package nephele.lab.art.bench;
