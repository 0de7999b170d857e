package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.level.Light;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A punctual light in the form of the shader: the cone as a ramp over the cosine, the range as 1/range². A point light
 * has a ramp that is 1 everywhere.
 *
 * @param axis unit direction of a spot, zero for a point
 * @param source the light as written
 */
public record PunctualLight(
        Vec3 position,
        Vec3 radiantIntensity,
        double rangeMetres,
        Vec3 axis,
        double coneScale,
        double coneOffset,
        Light source) {
    /** Squared distance below which the irradiance grows no further: a centimetre. */
    public static final double MIN_SQUARE_METRES = 1e-4;

    private static final double MIN_RANGE_METRES = 1e-3;
    private static final double MAX_RANGE_METRES = 1e9;
    private static final double MAX_WATTS_PER_STERADIAN = 1e12;

    /** Least width of the ramp; a narrower one is a step that a float cannot resolve. */
    private static final double MIN_COSINE_RAMP = 1e-4;

    /** Returns the light; empty if it has no effect: no range, no intensity, or invalid numbers. */
    public static Optional<PunctualLight> of(Light light) {
        Vec3 intensity = clampedIntensity(light.radiantIntensity());
        double range = Math.min(light.rangeMetres(), MAX_RANGE_METRES);
        boolean dark = intensity.equals(Vec3.ZERO);
        if (dark || !(range >= MIN_RANGE_METRES) || !isFinite(light.position())) {
            return Optional.empty();
        }
        if (light instanceof Light.Spot spot) {
            return ofSpot(spot, intensity, range);
        }
        return Optional.of(new PunctualLight(light.position(), intensity, range, Vec3.ZERO, 0, 1, light));
    }

    private static Optional<PunctualLight> ofSpot(Light.Spot spot, Vec3 intensity, double range) {
        Vector3d axis = spot.direction().toVector();
        double length = axis.length();
        double outer = Math.min(spot.outerConeDegrees(), 180);
        double inner = Math.min(spot.innerConeDegrees(), outer);
        if (!(length > 0 && length < Double.POSITIVE_INFINITY) || !(outer > 0) || Double.isNaN(inner)) {
            return Optional.empty();
        }
        axis.div(length);
        double cosOuter = StrictMath.cos(StrictMath.toRadians(outer));
        double cosInner = StrictMath.cos(StrictMath.toRadians(Math.max(inner, 0)));
        double scale = 1 / Math.max(cosInner - cosOuter, MIN_COSINE_RAMP);
        return Optional.of(new PunctualLight(
                spot.position(), intensity, range, new Vec3(axis.x, axis.y, axis.z), scale, -cosOuter * scale, spot));
    }

    private static Vec3 clampedIntensity(Vec3 i) {
        return new Vec3(clampedIntensity(i.x()), clampedIntensity(i.y()), clampedIntensity(i.z()));
    }

    private static double clampedIntensity(double i) {
        return i > 0 ? Math.min(i, MAX_WATTS_PER_STERADIAN) : 0;
    }

    private static boolean isFinite(Vec3 p) {
        return Double.isFinite(p.x()) && Double.isFinite(p.y()) && Double.isFinite(p.z());
    }

    public boolean isSpot() {
        return coneScale != 0;
    }

    public double inverseSquareRange() {
        return 1 / (rangeMetres * rangeMetres);
    }

    /** Returns the cosine of the outer half angle; −1 for a point light. */
    public double cosOuter() {
        return isSpot() ? -coneOffset / coneScale : -1;
    }

    /** Returns the irradiance at {@code p} on a plane perpendicular to the light, without shadow. */
    public Vector3d irradianceAt(Vec3 p) {
        Vector3d fromLight = p.toVector().sub(position.toVector());
        double d2 = fromLight.lengthSquared();
        double cosine = fromLight.dot(axis.toVector()) / Math.sqrt(Math.max(d2, 1e-12));
        double falloff = windowedInverseSquare(d2, inverseSquareRange()) * cone(cosine, coneScale, coneOffset);
        return radiantIntensity.toVector().mul(falloff);
    }

    /** Returns false only if the light cannot light anything in a box; conservative. */
    public boolean touches(Aabb box) {
        Vec3 p = position;
        double dx = outside(p.x(), box.minX(), box.maxX());
        double dy = outside(p.y(), box.minY(), box.maxY());
        double dz = outside(p.z(), box.minZ(), box.maxZ());
        return dx * dx + dy * dy + dz * dz <= rangeMetres * rangeMetres && (!isSpot() || coneMeets(box));
    }

    private static double outside(double x, double min, double max) {
        return Math.max(0, Math.max(min - x, x - max));
    }

    /**
     * Tests the box's bounding sphere against the cone: the angle to its centre, less the angle that its radius spans.
     */
    private boolean coneMeets(Aabb box) {
        Vec3 c = box.centre();
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        double radius = Math.sqrt(x * x + y * y + z * z) / 2;
        Vector3d towards = c.toVector().sub(position.toVector());
        double distance = towards.length();
        if (distance <= radius) {
            return true;
        }
        double cosine = Math.min(Math.max(towards.dot(axis.toVector()) / distance, -1), 1);
        double outer = StrictMath.acos(Math.min(Math.max(cosOuter(), -1), 1));
        return StrictMath.acos(cosine) - StrictMath.asin(radius / distance) <= outer + 1e-6;
    }

    /**
     * Returns the falloff with distance, the twin of {@code light-falloff.glsl}: the inverse square under a window that is zero at the range (Karis 2013, "Real Shading in Unreal Engine
     * 4", section "Lighting model").
     *
     * @return 1/m²
     */
    public static double windowedInverseSquare(double squareDistance, double inverseSquareRange) {
        double q = squareDistance * inverseSquareRange;
        double window = Math.min(Math.max(1 - q * q, 0), 1);
        return window * window / Math.max(squareDistance, MIN_SQUARE_METRES);
    }

    /**
     * Returns the falloff towards the edge of a cone, likewise: 1 inside the inner cone, 0 outside the outer one, and the square of a linear ramp of the cosine between
     * them.
     */
    public static double cone(double cosineFromAxis, double scale, double offset) {
        double t = Math.min(Math.max(cosineFromAxis * scale + offset, 0), 1);
        return t * t;
    }
}
