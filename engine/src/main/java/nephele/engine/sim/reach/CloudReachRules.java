package nephele.engine.sim.reach;

import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.PlacedRule;
import nephele.engine.level.rule.LevelRule;
import nephele.engine.math.Aabb;

/** Rules for clouds that are drawn as pictures from one point. */
public final class CloudReachRules {
    /** A cloud of technique skybox is neither where an eye can be nor where solids are. */
    public static final PlacedRule FAR = (level, statics, report) ->
            LevelRule.each("environment.clouds", level.environment().clouds(), (path, cloud) -> {
                if (cloud.technique() != CloudTechnique.SKYBOX) {
                    return;
                }
                Aabb bounds = bounds(cloud.extent());
                EyeReach.Part nearest = EyeReach.of(level, statics).nearest(bounds);
                if (nearest != null && EyeReach.metresBetween(nearest.box(), bounds) <= 0) {
                    report.accept(Problem.warning(
                            path + ".technique",
                            "an eye can be in this cloud " + nearest.means().words()
                                    + ", and a skybox is a picture from"
                                    + " one point: choose volume or auto, or move the cloud away"));
                } else if (statics.solids().stream()
                        .anyMatch(solid -> EyeReach.metresBetween(solid.shape().bounds(), bounds) <= 0)) {
                    report.accept(Problem.warning(
                            path + ".technique",
                            "a solid reaches into this cloud, and a skybox is cut there at one distance: choose volume"
                                    + " or auto, or move one of them"));
                }
            });

    private static final double FAR_METRES = Double.POSITIVE_INFINITY;

    private CloudReachRules() {}

    /** Returns the bounds of a cloud at the start; those of a layer are infinite along x and z. */
    public static Aabb bounds(Cloud.Extent extent) {
        if (extent instanceof Cloud.Extent.Layer layer) {
            double base = layer.baseAltitudeMetres();
            return new Aabb(-FAR_METRES, base, -FAR_METRES, FAR_METRES, base + layer.thicknessMetres(), FAR_METRES);
        }
        var volume = (Cloud.Extent.Volume) extent;
        return Aabb.around(volume.centre(), volume.size());
    }
}
