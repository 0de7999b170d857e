package nephele.engine.sim.state;

import nephele.engine.math.Vec3;

/**
 * The view angles, in thousandths of a degree: integers neither drift nor round, however long the game runs.
 *
 * @param yawMillidegrees wrapped into [−180 000, 180 000); 0 looks along −z, positive to the left
 * @param pitchMillidegrees positive upwards, clamped to ±89.9 degrees so that a forward direction always exists
 */
public record ViewAngles(int yawMillidegrees, int pitchMillidegrees) {
    private static final int HALF_TURN_MILLIDEGREES = 180_000;
    private static final int FULL_TURN_MILLIDEGREES = 360_000;
    private static final int MAX_PITCH_MILLIDEGREES = 89_900;
    /** The horizontal part of the view direction at the steepest pitch. */
    private static final double STEEP_COSINE = StrictMath.cos(Math.toRadians(89.9));

    public ViewAngles {
        yawMillidegrees = Math.floorMod(yawMillidegrees + (long) HALF_TURN_MILLIDEGREES, FULL_TURN_MILLIDEGREES)
                - HALF_TURN_MILLIDEGREES;
        pitchMillidegrees = Math.max(-MAX_PITCH_MILLIDEGREES, Math.min(MAX_PITCH_MILLIDEGREES, pitchMillidegrees));
    }

    /** Returns the nearest view angles; values that are not finite count as 0. */
    public static ViewAngles ofDegrees(double yawDegrees, double pitchDegrees) {
        return new ViewAngles((int) rounded(yawDegrees % 360), (int) rounded(pitchDegrees % 360));
    }

    /**
     * Returns the view angles nearest to a view. A view steeper than the steepest pitch takes its yaw from the up vector.
     *
     * @param back unit vector opposite to the view direction
     */
    public static ViewAngles nearest(Vec3 up, Vec3 back) {
        double flat = Math.sqrt(back.x() * back.x() + back.z() * back.z());
        double pitch = StrictMath.atan2(-back.y(), flat);
        double yaw = StrictMath.atan2(back.x(), back.z());
        if (flat < STEEP_COSINE) {
            yaw = back.y() < 0 ? StrictMath.atan2(up.x(), up.z()) : StrictMath.atan2(-up.x(), -up.z());
        }
        return ofDegrees(Math.toDegrees(yaw), Math.toDegrees(pitch));
    }

    private static long rounded(double degrees) {
        return Math.round(degrees * 1000);
    }

    /** Returns the view angles after a turn, in thousandths of a degree; the yaw wraps and the pitch is clamped. */
    public ViewAngles turned(int leftMillidegrees, int upMillidegrees) {
        long yaw = (long) yawMillidegrees + leftMillidegrees;
        long pitch = (long) pitchMillidegrees + upMillidegrees;
        return new ViewAngles((int) (yaw % FULL_TURN_MILLIDEGREES), (int)
                Math.max(-MAX_PITCH_MILLIDEGREES, Math.min(MAX_PITCH_MILLIDEGREES, pitch)));
    }

    /** Returns the yaw in [−π, π). */
    public double yawRadians() {
        return radians(yawMillidegrees);
    }

    /** Returns the pitch in radians, positive upwards. */
    public double pitchRadians() {
        return radians(pitchMillidegrees);
    }

    /** Returns the angle from this yaw to another one by the shorter way, in [−π, π). */
    public double yawRadiansTo(ViewAngles other) {
        int difference = other.yawMillidegrees - yawMillidegrees;
        return radians(
                Math.floorMod(difference + HALF_TURN_MILLIDEGREES, FULL_TURN_MILLIDEGREES) - HALF_TURN_MILLIDEGREES);
    }

    /** Converts to radians; divides first, so that a half turn is exactly π. */
    private static double radians(int millidegrees) {
        return millidegrees / (double) HALF_TURN_MILLIDEGREES * Math.PI;
    }
}
