package nephele.engine.level.rule;

import java.util.EnumSet;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Sky;

/** Rules for skies that cannot be shown. */
final class EnvironmentRules {
    /** A skybox names as many files as its layout needs, in its order. */
    static final LevelRule SKY_FILES = (level, assets, report) -> {
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            SkyboxOrder.objection(skybox).ifPresent(report);
        }
    };

    private static final Set<CloudTechnique> DRAWN = EnumSet.complementOf(EnumSet.of(CloudTechnique.SKYBOX));
    private static final Set<CloudTechnique> OF_BALLS = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.BILLBOARD);

    /** Warns of techniques of clouds that are not built yet, or that cannot show a cloud. */
    static final LevelRule TECHNIQUES = (level, assets, report) ->
            LevelRule.each("environment.clouds", level.environment().clouds(), (path, cloud) -> {
                boolean isDrawn = DRAWN.contains(cloud.technique());
                if (!isDrawn) {
                    report.accept(Problem.warning(
                                    path + ".technique",
                                    "is not drawn by this version yet; the cloud is drawn as a volume")
                            .about(Topic.NOT_DRAWN_YET));
                } else if (OF_BALLS.contains(cloud.technique()) && cloud.extent() instanceof Cloud.Extent.Layer) {
                    report.accept(Problem.warning(
                            path + ".technique",
                            "an endless layer is not divided into balls and is drawn as a volume: choose the kind"
                                    + " volume, or the technique auto"));
                }
            });

    private EnvironmentRules() {}
}
