package nephele.engine.level.appearance;

import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;

/** The dark plains and rayed craters of the moon; the twin of {@code moonAlbedo} in {@code atmosphere.frag}. */
final class MoonFace {
    /** Directions to the middles of the plains, east, north and towards the planet, and their radii in radians. */
    private static final double[][] SEAS = {
        {-0.231, 0.545, 0.806, 0.314},
        {0.273, 0.469, 0.840, 0.192},
        {0.509, 0.156, 0.847, 0.227},
        {0.820, 0.292, 0.493, 0.140},
        {0.770, -0.139, 0.623, 0.192},
        {0.554, -0.259, 0.791, 0.105},
        {-0.273, -0.358, 0.893, 0.192},
        {-0.575, -0.407, 0.710, 0.122},
        {-0.797, 0.342, 0.498, 0.314},
        {-0.718, -0.052, 0.694, 0.244},
        {-0.610, 0.139, 0.780, 0.209},
        {0.047, 0.839, 0.543, 0.105},
        {-0.256, 0.839, 0.481, 0.105},
        {0.068, 0.225, 0.972, 0.087},
        {-0.385, -0.174, 0.907, 0.122}
    };

    /** Directions to young craters with bright rays, and their sizes. */
    private static final double[][] RAYED = {
        {-0.140, -0.682, 0.718, 0.628},
        {-0.337, 0.174, 0.925, 0.279},
        {-0.610, 0.139, 0.780, 0.157},
        {-0.668, 0.407, 0.623, 0.157},
        {0.864, -0.156, 0.479, 0.209},
        {0.703, 0.276, 0.656, 0.122}
    };

    private static final SeededNoise NOISE = new SeededNoise(0);

    /** Moves the cells of the noise, as the shader does. */
    private static final double CELLS = 4096;

    private MoonFace() {}

    /** Returns the albedo of a place, a unit vector east, north and towards the planet, relative to the mean. */
    static double albedo(Vec3 place) {
        double rough = 0;
        double weight = 0.5;
        double scale = 2.7;
        for (int octave = 0; octave < 5; octave++) {
            rough += weight
                    * (NOISE.at(CELLS + scale * place.x(), CELLS + scale * place.y(), CELLS + scale * place.z()) - 0.5);
            weight *= 0.65;
            scale *= 2;
        }
        double sea = 0;
        for (double[] plain : SEAS) {
            double apart = place.minus(direction(plain)).length() / plain[3];
            sea = Math.max(sea, 1 - smoothStep((apart + 1.7 * rough - 0.85) / 0.4));
        }
        double ground = (1 + 0.6 * rough) * (1 - sea) + (0.5 + 0.3 * rough) * sea;
        return ground + 0.45 * rays(place);
    }

    private static double rays(Vec3 place) {
        double bright = 0;
        for (int i = 0; i < RAYED.length; i++) {
            Vec3 crater = direction(RAYED[i]);
            Vec3 from = place.minus(crater);
            double apart = from.length() / RAYED[i][3];
            Vec3 east = new Vec3(0, 1, 0).cross(crater);
            east = east.scaled(1 / east.length());
            double angle = Math.atan2(from.dot(crater.cross(east)), from.dot(east));
            double streak = 0.5 + 0.5 * Math.sin(angle * 9 + 2 * Math.sin(angle * 4 + i));
            bright = Math.max(bright, Math.exp(-1.6 * apart) * (0.15 + 0.85 * streak * streak * streak));
            bright = Math.max(bright, Math.exp(-apart * apart * 90));
        }
        return bright;
    }

    private static Vec3 direction(double[] row) {
        return new Vec3(row[0], row[1], row[2]);
    }

    private static double smoothStep(double t) {
        double clamped = Math.max(0, Math.min(1, t));
        return clamped * clamped * (3 - 2 * clamped);
    }
}
