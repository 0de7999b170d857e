/**
 * Periodic tables of random values from which clouds get their shapes: {@link nephele.engine.cloud.noise.CloudTables}
 * holds those of one seed. A table is what a repeated 3-D texture of OpenGL holds, and is interpolated as it is.
 */
package nephele.engine.cloud.noise;
