package nephele.engine.level.rule;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Sky;

/** Rules for skies that cannot be shown. */
final class EnvironmentRules {
    private static final Set<CloudTechnique> DRAWN =
            EnumSet.of(CloudTechnique.AUTO, CloudTechnique.VOLUME, CloudTechnique.SKYPLANE, CloudTechnique.PROCEDURAL);

    /** A skybox names as many files as its layout needs, in its order. */
    static final LevelRule SKY_FILES = (level, assets, report) -> {
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            SkyboxOrder.objection(skybox).ifPresent(report);
        }
    };

    /** Warns of techniques of clouds that are read and checked but not built yet. */
    static final LevelRule NOT_YET = (level, assets, report) -> {
        List<Cloud> clouds = level.environment().clouds();
        for (int i = 0; i < clouds.size(); i++) {
            CloudTechnique technique = clouds.get(i).technique();
            if (!DRAWN.contains(technique)) {
                report.accept(Problem.warning(
                                "environment.clouds[" + i + "].technique",
                                "is not drawn by this version yet; the cloud is drawn as a volume")
                        .about(Topic.NOT_DRAWN_YET));
            }
        }
    };

    private EnvironmentRules() {}
}
