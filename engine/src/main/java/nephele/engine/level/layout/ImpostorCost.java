package nephele.engine.level.layout;

import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.planted.PlantedModels;

/** The impostors are not so many, or of so many kinds, that a picture of them takes long. */
public final class ImpostorCost {
    /** CPU time of a first picture above which {@code check} warns. */
    private static final double LONG_SECONDS = 10;

    /** CPU time to draw the atlas of one kind of plant, measured on one core of a machine of 2024. */
    private static final double SECONDS_PER_KIND = 0.17;

    /** CPU time to place one plant. */
    private static final double SECONDS_PER_PLANT = 6e-5;

    private static final double MEGABYTES_PER_KIND = 6;

    public static final LevelRule FEW = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        if (PlantedModels.isIn(level)) {
            try {
                cost(plants(level), PlantedModels.kinds(statics), report);
            } catch (AssetException tooMany) {
                report.accept(Problem.error("models", tooMany.getMessage()));
            }
        }
    });

    private ImpostorCost() {}

    private static void cost(long plants, int kinds, Consumer<Problem> report) {
        double seconds = kinds * SECONDS_PER_KIND + plants * SECONDS_PER_PLANT;
        if (seconds > LONG_SECONDS) {
            report.accept(Problem.warning(
                    "models",
                    plants + " impostors of " + kinds + " kinds need some " + Math.round(seconds)
                            + " s of a processor's time before the first picture, and "
                            + Math.round(kinds * MEGABYTES_PER_KIND) + " MB for their pictures: plant fewer, or let"
                            + " more of them have the same mesh, material and form"));
        }
    }

    private static long plants(Level level) {
        return level.models().stream()
                .filter(ModelPlacement::impostor)
                .mapToLong(model -> model.isPlanted() ? model.field().count() : 1)
                .sum();
    }
}
