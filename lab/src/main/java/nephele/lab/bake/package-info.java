/**
 * Traced pictures of a level, kept in files until something that they depend on changes, and what {@code bake} writes: the sky
 * as six pictures, the light of the sky on the level's surfaces.
 */
package nephele.lab.bake;
