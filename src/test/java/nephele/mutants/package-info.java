/**
 * Faults planted one at a time into copies of sources and shaders, to see that a test of the suite fails: what guards the
 * tests. {@code gradle mutants} (or {@code ./nephele prove mutants}) runs all, the suite a few.
 */
package nephele.mutants;
