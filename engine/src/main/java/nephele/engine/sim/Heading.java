package nephele.engine.sim;

/**
 * Where the player looks, in thousandths of a degree: whole numbers neither drift nor round, however long the game.
 *
 * @param yawMillidegrees in [−180 000, 180 000); 0 looks along −z, positive to the left
 * @param pitchMillidegrees at most 89.9 degrees up or down, so that there is always a way "forward"
 */
public record Heading(int yawMillidegrees, int pitchMillidegrees) {
    private static final int HALF_TURN = 180_000;
    private static final int FULL_TURN = 360_000;
    private static final int STEEPEST = 89_900;

    public Heading {
        yawMillidegrees = Math.floorMod(yawMillidegrees + (long) HALF_TURN, FULL_TURN) - HALF_TURN;
        pitchMillidegrees = Math.max(-STEEPEST, Math.min(STEEPEST, pitchMillidegrees));
    }

    /** The nearest heading; not finite counts as 0. */
    public static Heading ofDegrees(double yawDegrees, double pitchDegrees) {
        return new Heading((int) rounded(yawDegrees % 360), (int) rounded(pitchDegrees % 360));
    }

    private static long rounded(double degrees) {
        return Math.round(degrees * 1000);
    }

    public Heading turned(int leftMillidegrees, int upMillidegrees) {
        long yaw = (long) yawMillidegrees + leftMillidegrees;
        long pitch = (long) pitchMillidegrees + upMillidegrees;
        return new Heading((int) (yaw % FULL_TURN), (int) Math.max(-STEEPEST, Math.min(STEEPEST, pitch)));
    }

    /** In [−π, π). */
    public double yawRadians() {
        return radians(yawMillidegrees);
    }

    public double pitchRadians() {
        return radians(pitchMillidegrees);
    }

    /** What has to be added to this yaw to reach another one by the shorter way, in [−π, π). */
    public double yawRadiansTo(Heading other) {
        int difference = other.yawMillidegrees - yawMillidegrees;
        return radians(Math.floorMod(difference + HALF_TURN, FULL_TURN) - HALF_TURN);
    }

    /** Divided first, so that a half turn is exactly π. */
    private static double radians(int millidegrees) {
        return millidegrees / (double) HALF_TURN * Math.PI;
    }
}
