package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares the table of the drawn sky with the integration in directions all around eyes on the ground and in the air. */
public final class SkyTableProof implements Proof {
    private static final int DIRECTIONS = 700;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    private static final int RANDOM_UNITS = 180;
    private static final double HIGHEST_METRES = 80_000;
    private static final double MOST_RMSE = 0.01;

    /** Heights in metres with elevations of the sun in degrees: the limits, the horizon, and where the limb shines alone. */
    private static final double[][] CHOSEN = {
        {0, 90},
        {2, 40},
        {2, 10},
        {2, 1},
        {2, 0},
        {2, -2},
        {2, -6},
        {2, -10},
        {1500, 5},
        {10_000, 30},
        {10_000, 0},
        {10_000, -5},
        {35_000, 3},
        {35_000, -4},
        {80_000, 60},
        {80_000, 0},
        {38_000, -8},
        {80_000, -6},
        {80_000, -8},
        {80_000, -10}
    };

    private final AirTables air = AirTables.of(Air.CLEAR);

    @Override
    public Claim claim() {
        return new Claim(
                "sky-table",
                "From 0 to 80 km, with the sun at −10 to 90 degrees, the table of the clear sky has a luminance RMSE"
                    + " of at most 1 % of the dome's mean against the integration, and no direction of sky and ground"
                    + " is off by more than 5 % of itself and 0.5 % of the mean.",
                "skies",
                CHOSEN.length + RANDOM_UNITS,
                20);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> {
            double[] place = unit < CHOSEN.length ? CHOSEN[(int) unit] : random(unit);
            return compared(unit, place[0], place[1]);
        });
    }

    /** Returns a height, half of them below 10 km, and an elevation of the sun, half of them below 10 degrees. */
    private static double[] random(long unit) {
        SplittableRandom random = new SplittableRandom(Hash64.combine(29, unit));
        double fraction = random.nextDouble();
        double metres = HIGHEST_METRES * fraction * fraction * fraction;
        double degrees = random.nextBoolean() ? random.nextDouble(-10, 10) : random.nextDouble(10, 90);
        return new double[] {metres, degrees};
    }

    private ProofResult compared(long unit, double height, double sunDegrees) {
        double angle = Math.toRadians(sunDegrees);
        Vec3 sun = new Vec3(0, Math.sin(angle), -Math.cos(angle));
        SkyTable table = new SkyTable(air, height, sun.y());
        ClearSky sky = new ClearSky(air);
        double[] exact = new double[DIRECTIONS];
        double mean = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            exact[i] = luminance(sky.radiance(height, direction(i), sun));
            mean += exact[i] / DIRECTIONS;
        }
        String where = String.format(Locale.ROOT, "unit %d, %.0f m, sun %.2f: ", unit, height, sunDegrees);
        List<String> failures = new ArrayList<>();
        double squares = 0;
        double greatest = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            double error = Math.abs(luminance(table.radiance(direction(i), sun)) - exact[i]);
            squares += error * error / DIRECTIONS;
            double allowed = 0.05 * exact[i] + 0.005 * mean;
            greatest = Math.max(greatest, error / allowed);
            if (!(error <= allowed)) {
                failures.add(where + direction(i) + " is off by " + error + " of " + exact[i]);
            }
        }
        double rmse = Math.sqrt(squares) / mean;
        if (!(rmse <= MOST_RMSE)) {
            failures.add(where + "luminance RMSE " + rmse);
        }
        return ProofResult.of(
                1,
                failures,
                Figure.greatest("greatest luminance RMSE", 100 * rmse, "% of the dome's mean"),
                Figure.greatest("greatest error of a direction", 100 * greatest, "% of what is allowed"));
    }

    private static Vec3 direction(int i) {
        double y = 1 - 2 * (i + 0.5) / DIRECTIONS;
        double radius = Math.sqrt(1 - y * y);
        return new Vec3(radius * Math.cos(i * GOLDEN_ANGLE), y, radius * Math.sin(i * GOLDEN_ANGLE));
    }

    private static double luminance(Vec3 rgb) {
        return 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z();
    }
}
