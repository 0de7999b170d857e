package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.Exit;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ExitCurtain;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The light that the curtains of exits add along a path: the integral of their emission, attenuated by fog and air. A
 * segment's two ways through a shell are integrated one by one with the midpoint rule; the air is that at its middle. While exposure is auto, the light is
 * infinite, so that metering leaves its pixels out; see {@link TracedExposure}.
 */
final class ExitLight {
    private static final int STEPS = 24;

    private final List<Exit> exits;
    private final double radiancePerDisplay;

    ExitLight(Level level) {
        exits = level.exits();
        Exposure exposure = level.environment().exposureStops();
        radiancePerDisplay = StrictMath.pow(2, -exposure.stopsOr(Double.NEGATIVE_INFINITY));
    }

    /**
     * Adds the light to the radiance at the end of a path.
     *
     * @param metres of the path that the eye sees; infinite for all
     */
    void addTo(Vector3d radiance, EyePath path, double metres, TracedLevel level) {
        if (exits.isEmpty()) {
            return;
        }
        for (EyePath.Segment segment : path.segments()) {
            for (Exit exit : exits) {
                add(exit, segment.shortened(metres - segment.metresBefore()), level, radiance);
            }
        }
    }

    private void add(Exit exit, EyePath.Segment segment, TracedLevel level, Vector3d radiance) {
        ExitCurtain curtain = new ExitCurtain(exit, 0);
        double[] outer = crossings(exit, segment, exit.radiusMetres());
        if (outer == null) {
            return;
        }
        double[] inner = crossings(exit, segment, (1 - ExitCurtain.SHELL_SHARE) * exit.radiusMetres());
        if (inner == null) {
            double middle = (outer[0] + outer[1]) / 2;
            inner = new double[] {middle, middle};
        }
        integrate(curtain, segment, outer[0], inner[0], level, radiance);
        integrate(curtain, segment, inner[1], outer[1], level, radiance);
    }

    /** Returns where the segment's line enters and leaves an endless cylinder, in metres; {@code null} if it does not. */
    private static double[] crossings(Exit exit, EyePath.Segment segment, double radius) {
        Vec3 d = segment.direction();
        double x = segment.origin().x() - exit.feet().x();
        double z = segment.origin().z() - exit.feet().z();
        double a = d.x() * d.x() + d.z() * d.z();
        double b = x * d.x() + z * d.z();
        double root = b * b - a * (x * x + z * z - radius * radius);
        if (root <= 0 || a == 0) {
            return null;
        }
        double half = StrictMath.sqrt(root);
        return new double[] {(-b - half) / a, (-b + half) / a};
    }

    private void integrate(
            ExitCurtain curtain,
            EyePath.Segment segment,
            double from,
            double to,
            TracedLevel level,
            Vector3d radiance) {
        double begin = Math.max(from, 0);
        double end = Math.min(to, segment.metres());
        double step = (end - begin) / STEPS;
        if (step <= 0) {
            return;
        }
        double middle = (begin + end) / 2;
        Vec3 place = segment.origin().addScaled(middle, segment.direction());
        Vector3d air = level.airTransmittance(place, segment.direction(), segment.metresBefore() + middle);
        for (int i = 0; i < STEPS; i++) {
            double metres = begin + (i + 0.5) * step;
            Vec3 emission = curtain.emissionPerMetre(segment.origin().addScaled(metres, segment.direction()));
            Vector3d light = emission.toVector().mul(step * radiancePerDisplay);
            double fraction = level.fogTransmittance(segment, segment.metresBefore() + metres);
            radiance.add(light.mul(segment.tint()).mul(air).mul(fraction));
        }
    }
}
