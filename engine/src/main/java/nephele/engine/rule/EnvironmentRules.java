package nephele.engine.rule;

import java.util.EnumSet;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Problem;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Vec3;

/** Rules for skies and lightning that cannot be shown. */
final class EnvironmentRules {
    /** A sun shines from a direction, its own or that of the hour. */
    static final LevelRule SUN = LevelRule.ofRecords((level, report) -> {
        Sun sun = level.environment().sun();
        if (sun != null
                && sun.directionTowardsSun() == null
                && !(level.environment().sky() instanceof Sky.Atmosphere)) {
            report.accept(Problem.error(
                    "environment.sun.directionTowardsSun",
                    "is missing: write a direction, such as [1, 2, 1]; only under a sky of the kind atmosphere the"
                            + " time of day gives one"));
        }
    });

    /** A skybox names as many files as its layout needs, in its order. */
    static final LevelRule SKY_FILES = LevelRule.ofRecords((level, report) -> {
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            SkyboxOrder.objection(skybox).ifPresent(report);
        }
    });

    private static final Set<CloudTechnique> OF_BALLS = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.BILLBOARD);

    /** Lightning can be seen, and strikes below where it starts. */
    static final LevelRule LIGHTNING = LevelRule.ofRecords((level, report) -> {
        Environment.Lightning lightning = level.environment().lightning();
        if (lightning == null) {
            return;
        }
        String path = "environment.lightning";
        if (lightning.strikesPerMinute() == 0) {
            report.accept(Problem.warning(
                    path + ".strikesPerMinute", "with 0 nothing is ever seen: give some 6, or leave lightning out"));
        }
        if (lightning.radiantIntensity().equals(Vec3.ZERO)) {
            report.accept(Problem.warning(
                    path + ".radiantIntensity", "black lightning is never seen: give it light, or leave this out"));
        }
        double base = lightning.centre().y() - lightning.size().y() / 2;
        if (lightning.groundShare() > 0 && lightning.groundAltitudeMetres() >= base) {
            report.accept(Problem.error(
                    path + ".groundAltitudeMetres",
                    "is not below the box, which begins at " + base
                            + " m: lower it, raise centre, or give groundShare 0"));
        }
    });

    /** Warns of a sky that nobody sees, because fog without end is before it. */
    static final LevelRule FOG = LevelRule.ofRecords((level, report) -> {
        Environment environment = level.environment();
        if (environment.sky() != null
                && environment.fog() != null
                && environment.fog().extinctionPerMetre() > 0
                && environment.fog().isEndless()) {
            report.accept(Problem.warning(
                    "environment.fog",
                    "has no end, so the sky lights the level but is not seen: give the fog a"
                            + " scaleHeightMetres, such as 20"));
        }
    });

    /** Warns of techniques of clouds that cannot show a cloud. */
    static final LevelRule TECHNIQUES = LevelRule.ofRecords((level, report) ->
            LevelRule.each("environment.clouds", level.environment().clouds(), (path, cloud) -> {
                if (OF_BALLS.contains(cloud.technique()) && cloud.extent() instanceof Cloud.Extent.Layer) {
                    report.accept(Problem.warning(
                            path + ".technique",
                            "an endless layer is not divided into balls and is drawn as a volume: choose the kind"
                                    + " volume, or the technique auto"));
                }
            }));

    private EnvironmentRules() {}
}
