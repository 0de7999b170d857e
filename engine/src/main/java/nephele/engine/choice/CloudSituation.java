package nephele.engine.choice;

import java.util.Locale;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Aabb;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.sim.reach.EyeReach;

/**
 * What the choice of a cloud's technique depends on.
 *
 * @param form its form in the table of errors, such as {@code layer cumulus}: whether the cloud is finite, and its
 *     density
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
                form(cloud),
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
    CloudSituation as(String other) {
        return new CloudSituation(
                other,
                opticalDepth,
                angularDegrees,
                sunDegrees,
                distanceMetres,
                behindMetres,
                travelMetres,
                moves,
                nearest);
    }

    /** Returns the form of a cloud. */
    public static String form(Cloud cloud) {
        String extent = cloud.extent() instanceof Cloud.Extent.Layer ? "layer " : "volume ";
        return extent + density(cloud.density());
    }

    /** Returns the form of this very cloud, whatever its id, its technique and the allowed error. */
    public static String formOfOnly(Cloud cloud) {
        Cloud same = new Cloud(
                "only",
                cloud.extent(),
                CloudTechnique.AUTO,
                cloud.density(),
                cloud.extinctionPerMetre(),
                cloud.albedo(),
                cloud.phaseG(),
                cloud.backLobe(),
                cloud.motion(),
                cloud.shafts(),
                Cloud.Tolerance.USUAL);
        return "cloud " + Long.toHexString(Hash64.of(LevelJson.line(same)));
    }

    private static String density(Density density) {
        if (density instanceof Density.Noise noise && noise.profile() != null) {
            return noise.profile().name().toLowerCase(Locale.ROOT);
        }
        return density.getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
