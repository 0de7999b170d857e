package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.render.frame.Quality;
import nephele.host.terminal.CommandFailure;
import nephele.lab.trade.Trade;

/** The registry of subjects, in the order of the report. */
public final class Trades {
    public static final List<Trade> ALL = withOtherSettings(List.of(
            QualitySubjects.PRESETS,
            QualitySubjects.RESOLUTION,
            QualitySubjects.UPSCALE,
            EdgeExperiment.ANTIALIASING,
            QualitySubjects.NORMAL_MAPS,
            QualitySubjects.BRDF,
            QualitySubjects.SHADOW_FILTER,
            QualitySubjects.LIGHT_SHADOWS,
            QualitySubjects.LIGHT_PARTS,
            QualitySubjects.CONTACT,
            BakedLightSubjects.BOUNCES,
            BakedLightSubjects.TEXELS,
            BakedLightSubjects.DIRECTIONS,
            ProbeSubject.TRADE,
            PictureSubjects.PORTAL_TECHNIQUE,
            PictureSubjects.PORTAL_BUDGET,
            PictureSubjects.PORTAL_BUDGET_BETWEEN_FACING,
            PictureSubjects.PORTAL_RESOLUTION,
            QualitySubjects.SHADOW,
            CloudSubjects.SCATTERING,
            CloudSubjects.STEP,
            CloudSubjects.RESOLUTION,
            CloudSubjects.LIGHT,
            CloudSubjects.FACING,
            CloudSubjects.BALL_LIGHT,
            CloudSubjects.IMPOSTORS,
            CloudSubjects.IMPOSTOR_ERROR,
            CloudSubjects.HISTORY,
            CloudSubjects.SHEET,
            CloudSubjects.NOISE,
            CloudSubjects.SKYBOX,
            OutdoorSubjects.TERRAIN_DETAIL,
            OutdoorSubjects.TERRAIN_ERROR,
            OutdoorSubjects.TERRAIN_LAYERS,
            OutdoorSubjects.IMPOSTORS,
            OutdoorSubjects.TREES,
            OutdoorSubjects.SPRITE_FACING,
            OutdoorSubjects.SPRITE_COVERAGE,
            EdgeExperiment.SAMPLES,
            PictureSubjects.ANISOTROPY,
            PictureSubjects.OUTPUT,
            PictureSubjects.CULLING,
            PictureSubjects.CULLING_OF_MANY,
            PlacementSubject.TRADE,
            TraversalSubject.TRADE,
            TickRateSubject.TRADE,
            SceneSubjects.SHADING,
            SceneSubjects.TESSELLATION,
            SceneSubjects.CONE_NORMALS,
            CullingSphereSubject.TRADE,
            CollisionSubject.TRADE));

    /** Name of the group of subjects that compare techniques of clouds. */
    public static final String CLOUDS = "clouds";

    private Trades() {}

    /** Returns the subjects, and one for each setting of quality that none of them covers. */
    private static List<Trade> withOtherSettings(List<Trade> subjects) {
        return Stream.concat(
                        subjects.stream(),
                        Quality.FIELDS.stream()
                                .filter(field -> subjects.stream().noneMatch(trade -> trade.qualityFields()
                                        .contains(field.name())))
                                .map(PictureSubjects::setting))
                .toList();
    }

    /**
     * Returns the subjects with these names, in the report's order; all of {@link #ALL} if no name is given. {@value #CLOUDS} names
     * the skies of the samples. A name that is unknown is a usage error.
     */
    public static List<Trade> named(List<String> subjects) {
        return named(subjects, CloudSubjects.SKIES);
    }

    /** Returns the subjects with these names, where {@value #CLOUDS} names the clouds of the request's level. */
    public static List<Trade> ofLevel(List<String> subjects) {
        return named(subjects, List.of(CloudSubjects.LEVEL));
    }

    private static List<Trade> named(List<String> subjects, List<Trade> clouds) {
        if (subjects.contains(CLOUDS)) {
            List<String> others = new ArrayList<>(subjects);
            others.removeIf(CLOUDS::equals);
            List<Trade> all = new ArrayList<>(clouds);
            if (!others.isEmpty()) {
                all.addAll(named(others, clouds));
            }
            return all;
        }
        for (String subject : subjects) {
            if (ALL.stream().noneMatch(trade -> trade.subject().equals(subject))) {
                var known = ALL.stream().map(Trade::subject).collect(Collectors.joining(", "));
                throw CommandFailure.usage(
                        "there is no subject `" + subject + "`; there are: " + CLOUDS + ", " + known);
            }
        }
        return subjects.isEmpty()
                ? ALL
                : ALL.stream()
                        .filter(trade -> subjects.contains(trade.subject()))
                        .toList();
    }
}
