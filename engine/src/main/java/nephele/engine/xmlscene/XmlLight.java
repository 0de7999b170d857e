package nephele.engine.xmlscene;

import nephele.engine.math.Vec3;

/** White, as in fixed-function OpenGL; in the frame of the group that holds it. */
public sealed interface XmlLight {
    record Point(Vec3 position) implements XmlLight {}

    /** @param towards the light */
    record Directional(Vec3 towards) implements XmlLight {}

    /** @param cutoffDegrees half the cone's angle, or 180 for all around */
    record Spot(Vec3 position, Vec3 direction, double cutoffDegrees, double exponent) implements XmlLight {}
}
