/** Resolves names given by a user: levels, their recorded walks, and viewpoints. Files precede the jar. */
package nephele.host.named;
