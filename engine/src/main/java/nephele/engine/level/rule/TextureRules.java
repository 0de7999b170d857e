package nephele.engine.level.rule;

import java.util.function.Consumer;
import nephele.engine.level.Problem;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;

/** The placement of a picture on a face can be inverted. */
final class TextureRules {
    static final LevelRule SCALES = (level, assets, report) -> LevelRule.each(
            "solids", level.solids(), (path, solid) -> SolidFaces.said(solid).forEach((name, face) -> {
                if (face.texture() != null) {
                    placement(path + "." + SolidFaces.path(solid, name) + ".texture", face.texture(), report);
                }
            }));

    private TextureRules() {}

    private static void placement(String path, TexturePlacement texture, Consumer<Problem> report) {
        scale(path + ".scaleU", texture.scaleU(), report);
        scale(path + ".scaleV", texture.scaleV(), report);
    }

    private static void scale(String path, double scale, Consumer<Problem> report) {
        if (!(Math.abs(scale) >= TexturePlacement.LEAST_SCALE)) {
            report.accept(Problem.error(
                    path, "the picture would have no size: give a scale of at least 0.001, or of at most -0.001"));
        }
    }
}
