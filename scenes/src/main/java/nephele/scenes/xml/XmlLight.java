package nephele.scenes.xml;

import nephele.engine.math.Vec3;

/** A white light, as in fixed-function OpenGL, in the frame of its group. */
public sealed interface XmlLight {
    record Point(Vec3 position) implements XmlLight {}

    /** @param towards the light */
    record Directional(Vec3 towards) implements XmlLight {}

    /** @param cutoffDegrees half the cone's angle, or 180 for all directions */
    record Spot(Vec3 position, Vec3 direction, double cutoffDegrees, double exponent) implements XmlLight {}
}
