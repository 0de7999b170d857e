package nephele.engine.rule;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.billboard.FieldPlanting;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;

/** Rules for billboards: where they stand, what their pictures hold, and whether fields have room for them. */
final class BillboardRules {
    static final LevelRule PLACES = LevelRule.ofRecords((level, report) -> {
        long sum = 0;
        for (int i = 0; i < level.billboards().size(); i++) {
            Billboards group = level.billboards().get(i);
            String path = "billboards[" + i + "]";
            places(path, group, level, report);
            long before = sum;
            sum += group.count();
            if (sum > Billboards.MOST && before <= Billboards.MOST) {
                report.accept(Problem.error(
                        path,
                        "a level shows at most " + Billboards.MOST + " billboards: list fewer, or lower the count"));
            }
        }
    });

    static final LevelRule MEANT = LevelRule.ofRecords((level, report) ->
            LevelRule.each("billboards", level.billboards(), (path, group) -> meant(path, group, report)));

    /** Plants every field; reports nothing where a file cannot be read or there are too many, which other rules do. */
    static final LevelRule ROOM = new LevelRule(LevelRule.Stage.FILES, (level, assets, statics, report) -> {
        long ofBillboards = planted(level.billboards().stream().map(Billboards::field));
        long ofModels = planted(level.models().stream().map(ModelPlacement::field));
        if (ofBillboards + ofModels > 0 && ofBillboards <= Billboards.MOST && ofModels <= PlantedModels.MOST) {
            room(level, assets, report);
        }
    });

    private static long planted(Stream<Billboards.Field> fields) {
        return fields.filter(Objects::nonNull)
                .mapToLong(Billboards.Field::count)
                .sum();
    }

    private BillboardRules() {}

    private static void places(String path, Billboards group, Level level, Consumer<Problem> report) {
        Billboards.Field field = group.field();
        if (field == null) {
            if (group.at().isEmpty()) {
                report.accept(Problem.error(path + ".at", "it stands nowhere: list places in at, or give it a field"));
            }
            return;
        }
        if (!group.at().isEmpty()) {
            report.accept(Problem.error(
                    path + ".field", "the places are in at already: keep one of the two, or split it in two"));
        }
        field(path + ".field", field, level, report);
    }

    /** Reports a field without ground or with limits in the wrong order. */
    static void field(String path, Billboards.Field field, Level level, Consumer<Problem> report) {
        if (field.terrain() != null
                && level.terrains().stream().noneMatch(terrain -> terrain.id().equals(field.terrain()))) {
            report.accept(Problem.error(
                    path + ".terrain",
                    "there is no terrain '" + field.terrain()
                            + "': leave it out to plant on the highest surfaces of everything"));
        } else if (field.terrain() == null
                && level.solids().isEmpty()
                && level.models().stream().allMatch(ModelPlacement::isPlanted)
                && level.terrains().isEmpty()) {
            report.accept(
                    Problem.error(path, "there is no ground to plant on: add a terrain, a solid or a model below it"));
        }
        Billboards.HeightLimits heights = field.heightRangeMetres();
        if (heights != null && heights.low() > heights.high()) {
            report.accept(
                    Problem.error(path + ".heightRangeMetres", "the lowest height comes first: exchange the two"));
        }
    }

    private static void meant(String path, Billboards group, Consumer<Problem> report) {
        if (group.framesPerSecond() > 0 && group.frames() == 1) {
            report.accept(Problem.warning(
                    path + ".framesPerSecond", "a picture of one frame stands still: say how many frames it has"));
        }
    }

    private static void room(Level level, AssetSource assets, Consumer<Problem> report) {
        Optional<FieldPlanting> planting = planting(level, assets);
        if (planting.isPresent()) {
            LevelRule.each(
                    "billboards",
                    level.billboards(),
                    (path, group) -> room(path + ".field", group.field(), planting.get(), assets, report));
            LevelRule.each(
                    "models",
                    level.models(),
                    (path, model) -> room(path + ".field", model.field(), planting.get(), assets, report));
        }
    }

    /** Returns nothing if a file cannot be read, which other rules report. */
    private static Optional<FieldPlanting> planting(Level level, AssetSource assets) {
        try {
            return Optional.of(new FieldPlanting(StaticShapes.of(level, assets)));
        } catch (AssetException | IllegalArgumentException reportedElsewhere) {
            return Optional.empty();
        }
    }

    /** @param field {@code null} for things that are not planted */
    private static void room(
            String path, Billboards.Field field, FieldPlanting planting, AssetSource assets, Consumer<Problem> report) {
        if (field == null || !planting.hasGround(field)) {
            return;
        }
        try {
            int fit = planting.plant(field, assets).size();
            if (fit < field.count()) {
                report.accept(Problem.error(
                        path + ".count",
                        fit + " fit at spacingMetres " + field.spacingMetres()
                                + " within the limits of height, slope and density: lower count or spacingMetres, or"
                                + " widen the limits"));
            }
        } catch (AssetException problem) {
            report.accept(
                    Problem.error(path + ".densityMap", problem.getMessage()).about(Topic.MISSING_ASSET));
        }
    }

    /** Reports a picture that does not hold its frames. @param width of the picture, pixels */
    static void frames(String path, Billboards group, int width, Consumer<Problem> report) {
        if (width % group.frames() != 0) {
            report.accept(Problem.error(
                    path + ".frames",
                    group.sprite() + " is " + width + " pixels wide, which " + group.frames()
                            + " frames of one width do not fill: give the number of pictures in its row"));
        }
    }
}
