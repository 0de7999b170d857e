package nephele.lab.generate;

import nephele.engine.math.Chance;
import org.joml.Vector3d;

/** A sequence of random numbers: the same seed always gives the same sequence. */
final class PlantDice {
    private final long seed;
    private long index;

    PlantDice(long seed) {
        this.seed = seed;
    }

    /** Returns a number from {@code least} (included) to {@code most}. */
    double between(double least, double most) {
        return least + (most - least) * Chance.unit(Chance.dice(seed, index++), 0);
    }

    /** Returns a number from −{@code size} to {@code size}. */
    double around(double size) {
        return between(-size, size);
    }

    /** Returns a unit vector, equally likely in all directions. */
    Vector3d direction() {
        double y = around(1);
        double flat = StrictMath.sqrt(1 - y * y);
        double turn = between(0, 2 * StrictMath.PI);
        return new Vector3d(flat * StrictMath.cos(turn), y, flat * StrictMath.sin(turn));
    }

    /** Returns a point of the unit ball, equally likely everywhere. */
    Vector3d inBall() {
        return direction().mul(StrictMath.cbrt(between(0, 1)));
    }
}
