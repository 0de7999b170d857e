package nephele.engine.level.appearance;

import nephele.engine.level.Exit;
import nephele.engine.math.Vec3;

/**
 * The light of an exit: a shell along the cylinder's side, {@value #SHELL_SHARE} of its radius thick, that emits light
 * and absorbs none. The emission fades with height and varies around the axis in waves that wander with time. The twin
 * of {@code exit-curtain.glsl}; the veil that is drawn between the strands is a decoration and has none.
 */
public final class ExitCurtain {
    /** Thickness of the shell as a share of the radius. */
    public static final double SHELL_SHARE = 0.15;

    /** Display value, linear, of the shell at its base seen at a right angle: emission is scaled by exposure. */
    private static final double BASE = 0.66;

    private static final Vec3 LOW_COLOUR = new Vec3(1, 0.86, 0.58);
    private static final Vec3 HIGH_COLOUR = new Vec3(0.72, 0.92, 1);

    private final Exit exit;
    private final double seconds;

    /** @param seconds time, which moves the waves */
    public ExitCurtain(Exit exit, double seconds) {
        this.exit = exit;
        this.seconds = seconds;
    }

    /**
     * Returns the emission at a point in display values, linear RGB, per metre; zero outside the shell. Divided by the
     * exposure factor it is a radiance per metre.
     */
    public Vec3 emissionPerMetre(Vec3 point) {
        double x = point.x() - exit.feet().x();
        double z = point.z() - exit.feet().z();
        double height = (point.y() - exit.feet().y()) / exit.heightMetres();
        double fraction = StrictMath.sqrt(x * x + z * z) / exit.radiusMetres();
        if (height < 0 || height > 1 || fraction > 1 || fraction < 1 - SHELL_SHARE) {
            return Vec3.ZERO;
        }
        double thickness = SHELL_SHARE * exit.radiusMetres();
        double strength = BASE / thickness * fade(height) * waves(StrictMath.atan2(z, x));
        return LOW_COLOUR.lerp(HIGH_COLOUR, height).scaled(strength);
    }

    private static double fade(double height) {
        return (1 - height * height) * (1 + 2 * StrictMath.exp(-24 * height));
    }

    private double waves(double angle) {
        return 1
                + 0.4 * StrictMath.sin(5 * angle + 0.7 * seconds)
                + 0.3 * StrictMath.sin(12 * angle - 1.1 * seconds)
                + 0.2 * StrictMath.sin(23 * angle + 1.6 * seconds);
    }
}
