package nephele.engine.cloud.field;

import java.util.OptionalDouble;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * A homogeneous medium in the ellipsoid that is inscribed in a box.
 *
 * @param bounds the box; finite
 * @param extinctionPerMetre at least 0
 */
public record EllipsoidField(Aabb bounds, double extinctionPerMetre) implements ExtinctionField {
    @Override
    public double perMetre(double x, double y, double z) {
        double u = fromCentre(x, bounds.minX(), bounds.maxX());
        double v = fromCentre(y, bounds.minY(), bounds.maxY());
        double w = fromCentre(z, bounds.minZ(), bounds.maxZ());
        return u * u + v * v + w * w <= 1 ? extinctionPerMetre : 0;
    }

    @Override
    public boolean isEmpty() {
        return extinctionPerMetre == 0 || bounds.isEmpty();
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new UniformWalk(chord(ray, fromMetres, toMetres), extinctionPerMetre);
    }

    @Override
    public OptionalDouble closedDepth(Ray ray, double fromMetres, double toMetres) {
        RaySpan chord = chord(ray, fromMetres, toMetres);
        return OptionalDouble.of(chord.isEmpty() ? 0 : extinctionPerMetre * (chord.toMetres() - chord.fromMetres()));
    }

    /** Returns the position on an axis scaled so that the ellipsoid reaches from −1 to 1. */
    private static double fromCentre(double at, double min, double max) {
        return (2 * at - (min + max)) / (max - min);
    }

    /** Measures from the point nearest to the centre, where the quadratic equation loses no digits to a far origin. */
    private RaySpan chord(Ray ray, double fromMetres, double toMetres) {
        double ox = fromCentre(ray.originX(), bounds.minX(), bounds.maxX());
        double oy = fromCentre(ray.originY(), bounds.minY(), bounds.maxY());
        double oz = fromCentre(ray.originZ(), bounds.minZ(), bounds.maxZ());
        double dx = 2 * ray.directionX() / (bounds.maxX() - bounds.minX());
        double dy = 2 * ray.directionY() / (bounds.maxY() - bounds.minY());
        double dz = 2 * ray.directionZ() / (bounds.maxZ() - bounds.minZ());
        double squared = dx * dx + dy * dy + dz * dz;
        double nearest = -(ox * dx + oy * dy + oz * dz) / squared;
        double mx = ox + nearest * dx;
        double my = oy + nearest * dy;
        double mz = oz + nearest * dz;
        double left = 1 - (mx * mx + my * my + mz * mz);
        if (!(left > 0) || !ray.isCastable()) {
            return RaySpan.EMPTY;
        }
        double half = Math.sqrt(left / squared);
        return new RaySpan(Math.max(fromMetres, nearest - half), Math.min(toMetres, nearest + half));
    }
}
