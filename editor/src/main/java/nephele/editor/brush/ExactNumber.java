package nephele.editor.brush;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Rounding that removes the noise of floating point arithmetic from numbers that people typed or snapped. */
final class ExactNumber {
    /** Noise of one or two additions, relative to 1 m or the number. */
    static final double OF_SUMS = 1e-14;

    /** Noise of an intersection of planes, relative to 1 m or the number. */
    static final double OF_INTERSECTIONS = 1e-12;

    private static final double DECIMALS = 1e9;
    private static final double LARGEST = 1e6;
    private static final double DISTANCE_STEPS_PER_METRE = 0x1p40;

    private ExactNumber() {}

    /** Returns the number with nine decimals that is nearer than the noise; the number itself if there is none. */
    static double clean(double value, double noise) {
        return clean(value, noise, value);
    }

    /** Returns the same for the sum of numbers of which the largest has a magnitude. */
    private static double clean(double value, double noise, double magnitude) {
        if (!(Math.abs(value) <= LARGEST)) {
            return value;
        }
        double rounded = Math.rint(value * DECIMALS) / DECIMALS;
        return Math.abs(rounded - value) <= noise * Math.max(1, Math.abs(magnitude)) ? rounded + 0.0 : value;
    }

    static Vec3 clean(Vec3 v, double noise) {
        return new Vec3(clean(v.x(), noise), clean(v.y(), noise), clean(v.z(), noise));
    }

    /** Returns the edge lengths of a box, without noise. */
    static Vec3 size(Aabb box) {
        return size(box, OF_SUMS);
    }

    static Vec3 size(Aabb box, double noise) {
        return new Vec3(
                clean(box.maxX() - box.minX(), noise, magnitude(box.minX(), box.maxX())),
                clean(box.maxY() - box.minY(), noise, magnitude(box.minY(), box.maxY())),
                clean(box.maxZ() - box.minZ(), noise, magnitude(box.minZ(), box.maxZ())));
    }

    /** Returns the middle of a box, without noise. */
    static Vec3 centre(Aabb box) {
        return centre(box, OF_SUMS);
    }

    static Vec3 centre(Aabb box, double noise) {
        Vec3 centre = box.centre();
        return new Vec3(
                clean(centre.x(), noise, magnitude(box.minX(), box.maxX())),
                clean(centre.y(), noise, magnitude(box.minY(), box.maxY())),
                clean(centre.z(), noise, magnitude(box.minZ(), box.maxZ())));
    }

    private static double magnitude(double a, double b) {
        return Math.max(Math.abs(a), Math.abs(b));
    }

    /**
     * Returns the nearest multiple of 2⁻⁴⁰ m (10⁻¹² m). Sums of such distances are exact up to 8 km, so that an oblique
     * plane that is moved there and back has the same bits.
     */
    static double snapped(double distanceMetres) {
        return Math.rint(distanceMetres * DISTANCE_STEPS_PER_METRE) / DISTANCE_STEPS_PER_METRE + 0.0;
    }

    /** Returns the vector without negative zeros, which records distinguish from positive ones. */
    static Vec3 positiveZeros(Vec3 v) {
        return new Vec3(v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
    }
}
