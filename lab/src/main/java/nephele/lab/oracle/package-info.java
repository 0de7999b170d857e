/** Traces the oracle's pictures for the engine's views, and caches them until something that they depend on changes. */
package nephele.lab.oracle;
