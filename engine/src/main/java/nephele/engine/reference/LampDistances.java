package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;

/**
 * Random distances along a straight part of a path that are likely where much of a lamp's light is scattered towards its
 * beginning: even over the angle at which the lamp sees them (Kulla and Fajardo 2012, "Importance Sampling Techniques for
 * Path Tracing in Participating Media", section 4.1), or in a cloud by its phase function over that angle, piece by piece.
 */
final class LampDistances {
    private static final double LEAST_METRES = StrictMath.sqrt(PunctualLight.MIN_SQUARE_METRES);

    /** Pieces of the angle, narrow where light goes on almost straight. */
    private static final int PIECES = 16;

    /** The part of distances that is even over the angle, in that of a phase function without direction. */
    private static final double EVEN_PER_STERADIAN = 0.2 / (4 * Math.PI);

    private final double from;
    private final double to;
    /** Distance of the place nearest to the lamp. */
    private final double middle;
    /** Distance of the lamp from there. */
    private final double off;

    private final double firstAngle;
    private final double allAngles;
    private final PhaseFunction phase;
    private double metres;
    private double perMetre;

    /** @param phase of the cloud around the lamp; without direction, distances are even over the angle */
    LampDistances(EyePath.Segment part, PunctualLight lamp, PhaseFunction phase) {
        this.phase = phase;
        middle = lamp.position().minus(part.origin()).dot(part.direction());
        Vec3 nearest = part.origin().addScaled(middle, part.direction());
        double distance = lamp.position().minus(nearest).length();
        double half = Math.sqrt(Math.max(0, lamp.rangeMetres() * lamp.rangeMetres() - distance * distance));
        from = Math.max(0, middle - half);
        to = Math.min(part.metres(), middle + half);
        off = Math.max(distance, LEAST_METRES);
        firstAngle = StrictMath.atan((from - middle) / off);
        allAngles = StrictMath.atan((to - middle) / off) - firstAngle;
    }

    /** Returns true if the lamp's light reaches no place of the part. */
    boolean isEmpty() {
        return !(from < to);
    }

    /** Chooses a distance. */
    void choose(SplittableRandom random) {
        double[] weightBefore = new double[PIECES + 1];
        for (int piece = 0; piece < PIECES; piece++) {
            double width = edge(piece + 1) - edge(piece);
            double angle = firstAngle + allAngles * (edge(piece) + width / 2);
            double scattered = phase.perSteradian(2 + 2 * StrictMath.sin(angle));
            weightBefore[piece + 1] = weightBefore[piece] + width * (scattered + EVEN_PER_STERADIAN);
        }
        double chosen = random.nextDouble() * weightBefore[PIECES];
        int piece = 0;
        while (piece < PIECES - 1 && weightBefore[piece + 1] <= chosen) {
            piece++;
        }
        double width = edge(piece + 1) - edge(piece);
        double fraction = (weightBefore[piece + 1] - weightBefore[piece]) / weightBefore[PIECES];
        double beyond = off * StrictMath.tan(firstAngle + allAngles * (edge(piece) + width * random.nextDouble()));
        metres = Math.min(Math.max(middle + beyond, from), to);
        perMetre = fraction / (width * allAngles) * off / (off * off + beyond * beyond);
    }

    private static double edge(int piece) {
        double fraction = (double) piece / PIECES;
        return fraction * fraction;
    }

    /** Returns the chosen distance from the part's beginning. */
    double metres() {
        return metres;
    }

    /** Returns the density per metre with which it was chosen. */
    double perMetre() {
        return perMetre;
    }
}
