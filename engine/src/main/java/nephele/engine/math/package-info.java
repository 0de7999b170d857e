/**
 * Small geometric value types in double precision; JOML provides the linear algebra. Metres, right-handed, y up. {@code
 * math.bvh} holds the one spatial index, {@code math.heightfield} grids of heights.
 */
package nephele.engine.math;
