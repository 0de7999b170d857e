package nephele.engine.math;

/**
 * Where somebody looks, radians: yaw in [−π, π), 0 along −z and positive to the left; pitch within ±89.9°, positive
 * upwards. Turning adds angles, so it never passes through a pole and drifts by no rotation.
 */
public record YawPitch(double yaw, double pitch) {
    public static final double GREATEST_PITCH = StrictMath.toRadians(89.9);

    public YawPitch {
        yaw = wrapped(yaw);
        pitch = Double.isNaN(pitch) ? 0 : Math.max(-GREATEST_PITCH, Math.min(GREATEST_PITCH, pitch));
    }

    /** Turned by as much as the mouse asks; what is not finite turns nothing. */
    public YawPitch turned(double yawChange, double pitchChange) {
        return new YawPitch(
                yaw + (Double.isFinite(yawChange) ? yawChange : 0),
                pitch + (Double.isFinite(pitchChange) ? pitchChange : 0));
    }

    public Basis basis() {
        return Basis.ofYawPitch(yaw, pitch);
    }

    /** The same angle in [−π, π); 0 for what is not finite. */
    public static double wrapped(double angle) {
        if (!Double.isFinite(angle)) {
            return 0;
        }
        if (angle >= -Math.PI && angle < Math.PI) {
            return angle;
        }
        double remainder = StrictMath.IEEEremainder(angle, 2 * Math.PI);
        return remainder >= Math.PI ? -Math.PI : Math.max(-Math.PI, remainder);
    }

    /** The yaw of a horizontal direction, 0 where it has none: atan2 knows all quadrants, atan(x / z) only half. */
    public static double yawOf(double x, double z) {
        return x == 0 && z == 0 ? 0 : wrapped(StrictMath.atan2(-x, -z));
    }
}
