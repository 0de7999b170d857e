package nephele.engine.rule;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Problem;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.level.json.WordFormats;
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
            skyboxObjection(skybox).ifPresent(report);
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

    /** Returns an error for another number than the layout's, or a warning if the names tell another order. */
    private static Optional<Problem> skyboxObjection(Sky.Skybox skybox) {
        int wanted = SkyboxSquare.files(skybox.layout());
        int listed = skybox.files().size();
        String layout = "layout " + WordFormats.Choice.word(skybox.layout());
        List<String> names = SkyboxSquare.of(skybox.layout()).stream()
                .map(SkyboxSquare::name)
                .toList();
        if (listed != wanted) {
            String order = wanted == 1 ? "" : "; list them in the order " + String.join(", ", names);
            return Optional.of(Problem.error(
                    "environment.sky.files", layout + " needs " + wanted + " files, not " + listed + order));
        }
        List<String> ends =
                skybox.files().stream().map(file -> endOf(file, names)).toList();
        boolean isAnotherOrder = !ends.equals(names) && new HashSet<>(ends).equals(new HashSet<>(names));
        return isAnotherOrder
                ? Optional.of(Problem.warning(
                        "environment.sky.files",
                        "the files' names end in " + String.join(", ", ends) + "; " + layout + " reads them as "
                                + String.join(", ", names)))
                : Optional.empty();
    }

    /** Returns the square's name with which a file's name ends before its extension, empty if there is none. */
    private static String endOf(String file, List<String> names) {
        String stem = file.replaceFirst("\\.[^./]*$", "");
        return names.stream().filter(stem::endsWith).findFirst().orElse("");
    }
}
