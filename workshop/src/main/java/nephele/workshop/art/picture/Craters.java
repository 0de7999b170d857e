package nephele.workshop.art.picture;

import nephele.engine.math.SeededNoise;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Craters on a globe, few large and many small, the youngest with bright rays. */
final class Craters {
    private static final double YOUNG_SHARE = 0.06;

    private final Vector3d[] centres;
    private final double[] radii;
    /** The depth of each crater relative to a fresh one, 0.3–1. */
    private final double[] depths;

    private final boolean[] young;
    private final SphereNoise rough;

    Craters(int seed, int count, double largestRadius) {
        SeededNoise noise = new SeededNoise(seed);
        rough = new SphereNoise(seed + 5);
        centres = new Vector3d[count];
        radii = new double[count];
        depths = new double[count];
        young = new boolean[count];
        for (int i = 0; i < count; i++) {
            double latitude = StrictMath.toDegrees(StrictMath.asin(2 * noise.unit(i, 0, 0) - 1));
            centres[i] = Globe.direction(360 * noise.unit(i, 1, 0), latitude);
            double size = noise.unit(i, 2, 0);
            radii[i] = largestRadius * (0.07 + 0.93 * size * size * size * size * size);
            young[i] = noise.unit(i, 3, 0) < YOUNG_SHARE;
            depths[i] = young[i] ? 1 : 0.3 + 0.7 * noise.unit(i, 4, 0);
        }
    }

    /** Returns the change of the ground's brightness: negative in the bowls, positive on rims and rays; −1…1. */
    double relief(Vector3dc p) {
        double sum = 0;
        double ragged = 1 + 0.12 * rough.cloud(p, 14, 2);
        for (int i = 0; i < centres.length; i++) {
            double reach = radii[i] * (young[i] ? 6 : 1.6);
            double squared = centres[i].distanceSquared(p);
            if (squared < reach * reach) {
                sum += depths[i] * profile(Math.sqrt(squared) / radii[i] * ragged);
                sum += young[i] ? rays(p, i, Math.sqrt(squared) / radii[i]) : 0;
            }
        }
        return Math.max(-1, Math.min(1, sum));
    }

    private static double profile(double distance) {
        double bowl = -0.4 * (1 - Shapes.ramp(0.3, 1, distance));
        double rim = 0.42 * Shapes.ramp(0.75, 1, distance) * (1 - Shapes.ramp(1, 1.6, distance));
        double peak = 0.3 * (1 - Shapes.ramp(0.05, 0.22, distance));
        return bowl + rim + peak;
    }

    private double rays(Vector3dc p, int i, double distance) {
        Vector3d side = new Vector3d(centres[i]).cross(0.31, 0.87, 0.38).normalize();
        Vector3d other = new Vector3d(centres[i]).cross(side);
        double angle = StrictMath.atan2(p.dot(other), p.dot(side));
        double streak = rough.smooth(3.2 * StrictMath.sin(angle) + i, 3.2 * StrictMath.cos(angle), 4.5 * i);
        double fade = 1 - Shapes.ramp(1, 6, distance);
        return 0.55 * fade * fade * Shapes.ramp(0.05, 0.5, streak) * Shapes.ramp(0.8, 1.1, distance);
    }
}
