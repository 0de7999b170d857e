/** Small geometric value types in double precision; JOML provides the linear algebra. Metres, right-handed, y up. */
package nephele.engine.math;
