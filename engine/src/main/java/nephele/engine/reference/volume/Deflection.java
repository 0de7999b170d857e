package nephele.engine.reference.volume;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;

/** Turns unit directions by a separation |d − l|², with a random angle around the old direction. */
public final class Deflection {
    private Deflection() {}

    /**
     * Returns a random unit direction of the given separation from {@code direction}. The frame is that of Duff et al.
     * 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1).
     */
    public static Vec3 of(Vec3 direction, double separation, SplittableRandom random) {
        double angle = 2 * Math.PI * random.nextDouble();
        double sine = Math.sqrt(Math.max(0, separation * (1 - separation / 4)));
        double a = sine * StrictMath.cos(angle);
        double b = sine * StrictMath.sin(angle);
        double cosine = 1 - separation / 2;
        double sign = Math.copySign(1, direction.z());
        double p = -1 / (sign + direction.z());
        double q = direction.x() * direction.y() * p;
        double x = a * (1 + sign * direction.x() * direction.x() * p) + b * q + cosine * direction.x();
        double y = a * sign * q + b * (sign + direction.y() * direction.y() * p) + cosine * direction.y();
        double z = -a * sign * direction.x() - b * direction.y() + cosine * direction.z();
        double inverse = 1 / Math.sqrt(x * x + y * y + z * z);
        return new Vec3(x * inverse, y * inverse, z * inverse);
    }

    /** Returns |a − b|². */
    public static double separation(Vec3 a, Vec3 b) {
        double x = a.x() - b.x();
        double y = a.y() - b.y();
        double z = a.z() - b.z();
        return x * x + y * y + z * z;
    }
}
