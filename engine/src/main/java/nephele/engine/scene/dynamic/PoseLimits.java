package nephele.engine.scene.dynamic;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState.Posture;

/** Clamps postures to valid ranges and replaces NaN and infinities, so that every part's position is finite. */
final class PoseLimits {
    private static final double LOWEST_METRES = 0.9;
    private static final double HIGHEST_METRES = 2.2;
    private static final double QUICKEST_STRIDE = 3;
    private static final double FULL_TURN_RADIANS = 2 * Math.PI;

    private PoseLimits() {}

    static Posture sane(Posture p) {
        Vec3 up = Directions.unit(p.up());
        return new Posture(
                new Vec3(
                        finite(p.centre().x()),
                        finite(p.centre().y()),
                        finite(p.centre().z())),
                up == null ? new Vec3(0, 1, 0) : up,
                finite(p.yawRadians()) % FULL_TURN_RADIANS,
                within(p.pitchRadians(), -Math.PI / 2, Math.PI / 2),
                within(p.heightMetres(), LOWEST_METRES, HIGHEST_METRES),
                finite(p.step()) - Math.floor(finite(p.step())),
                within(p.stride(), 0, QUICKEST_STRIDE),
                Math.IEEEremainder(finite(p.travelRadians()), FULL_TURN_RADIANS),
                within(p.airborne(), 0, 1),
                within(p.carrying(), 0, 1));
    }

    private static double finite(double x) {
        return Double.isFinite(x) ? x : 0;
    }

    private static double within(double x, double least, double most) {
        return Double.isNaN(x) ? Math.max(least, Math.min(most, 0)) : Math.max(least, Math.min(most, x));
    }
}
