package nephele.engine.cloud.field;

import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Where a cloud is at one moment. Far drifts are taken modulo the period of what drifts, in double precision.
 *
 * @param bounds infinite in x and z for a layer
 * @param centre of the extent; at x = z = 0 for a layer without drift
 * @param drift how far the wind has carried it, metres
 */
record CloudMoment(Aabb bounds, Vec3 centre, Vec3 drift) {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    static CloudMoment of(Cloud cloud, double seconds) {
        Vec3 drift = cloud.motion().drift(seconds);
        if (cloud.extent() instanceof Cloud.Extent.Volume volume) {
            Vec3 centre = volume.centre().plus(drift);
            return new CloudMoment(Aabb.around(centre, volume.size()), centre, drift);
        }
        var layer = (Cloud.Extent.Layer) cloud.extent();
        double base = layer.baseAltitudeMetres();
        double top = base + layer.thicknessMetres();
        var along = new Vec3(drift.x(), 0, drift.z());
        return new CloudMoment(
                new Aabb(-INFINITE, base, -INFINITE, INFINITE, top, INFINITE),
                along.plus(new Vec3(0, base + layer.thicknessMetres() / 2, 0)),
                along);
    }

    boolean isLayer() {
        return bounds.maxX() == INFINITE;
    }

    double heightMetres() {
        return bounds.maxY() - bounds.minY();
    }

    /** Returns the drift within one period of a pattern. */
    Vec3 driftWithin(double periodX, double periodZ) {
        return new Vec3(within(drift.x(), periodX), 0, within(drift.z(), periodZ));
    }

    private static double within(double metres, double period) {
        return metres - period * Math.floor(metres / period);
    }
}
