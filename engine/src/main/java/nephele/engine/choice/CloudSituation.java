package nephele.engine.choice;

import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.sim.reach.EyeReach;

/**
 * What the choice of a cloud's technique depends on.
 *
 * @param form the word of its form in the table of errors
 * @param opticalDepth mean of its upright columns that have any
 * @param angularDegrees its least extent seen from where the eye is nearest: of a layer its thickness
 * @param sunDegrees elevation of the light
 * @param distanceMetres least distance of the eye from it; 0 for an eye that can be inside
 * @param behindMetres from its near side to its middle
 * @param travelMetres greatest distance of the eye from the middle of where it can be
 * @param moves whether it drifts or takes other shapes
 * @param nearest where the eye is nearest; {@code null} if it can be anywhere
 */
public record CloudSituation(
        String form,
        double opticalDepth,
        double angularDegrees,
        double sunDegrees,
        double distanceMetres,
        double behindMetres,
        double travelMetres,
        boolean moves,
        EyeReach.Part nearest) {
    /**
     * Returns the situation of a cloud.
     *
     * @param bounds its bounds at the start, without the curvature of the planet
     * @param opticalDepth mean of its upright columns that have any
     */
    public static CloudSituation of(Cloud cloud, Aabb bounds, double opticalDepth, EyeReach reach, double sunDegrees) {
        Aabb swayed = bounds.union(bounds.moved(cloud.motion().swayMetres()));
        Aabb met = drifted(swayed, cloud.motion().windMetresPerSecond());
        EyeReach.Part nearest = reach.nearest(met);
        double distance = nearest == null ? 0 : EyeReach.metresBetween(nearest.box(), met);
        double extent = extent(bounds);
        return new CloudSituation(
                CloudForm.of(cloud).word(),
                opticalDepth,
                2 * Math.toDegrees(Math.atan2(extent / 2, distance + extent / 2)),
                sunDegrees,
                distance,
                extent / 2,
                reach.isAnywhere()
                        ? Double.POSITIVE_INFINITY
                        : reach.farthestMetres(reach.bounds().centre()),
                !cloud.motion().equals(Cloud.Motion.STILL),
                nearest);
    }

    /** Returns what a cloud passes through in time: a drifting one comes to any place along its drift. */
    private static Aabb drifted(Aabb box, Vec3 wind) {
        double far = Double.POSITIVE_INFINITY;
        return new Aabb(
                wind.x() < 0 ? -far : box.minX(),
                wind.y() < 0 ? -far : box.minY(),
                wind.z() < 0 ? -far : box.minZ(),
                wind.x() > 0 ? far : box.maxX(),
                wind.y() > 0 ? far : box.maxY(),
                wind.z() > 0 ? far : box.maxZ());
    }

    private static double extent(Aabb box) {
        return Math.min(box.maxY() - box.minY(), Math.min(box.maxX() - box.minX(), box.maxZ() - box.minZ()));
    }

    /** Returns the situation of a cloud that the table knows under another form. */
    CloudSituation as(CloudForm other) {
        return new CloudSituation(
                other.word(),
                opticalDepth,
                angularDegrees,
                sunDegrees,
                distanceMetres,
                behindMetres,
                travelMetres,
                moves,
                nearest);
    }
}
