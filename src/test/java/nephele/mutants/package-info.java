/**
 * Mutation tests: faults planted one at a time into copies of sources and shaders, each of which a test of the suite
 * must detect. {@code gradle mutants} (or {@code ./nephele prove mutants}) runs all, the suite a few.
 */
package nephele.mutants;
