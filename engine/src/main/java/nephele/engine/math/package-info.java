/** Small value geometry in double precision; JOML does the linear algebra. Metres, right-handed, y up. */
package nephele.engine.math;
