/**
 * What the numbers of a level mean to the eye: how materials reflect, how a texture lies on a face, how lamps thin out,
 * what a sky sends. Formulas in double precision, each with its source; the shaders are their twins, the scene prepares
 * light with them and the reference traces with them.
 */
package nephele.engine.level.appearance;
