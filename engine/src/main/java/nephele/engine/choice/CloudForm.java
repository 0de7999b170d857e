package nephele.engine.choice;

import java.util.Locale;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Hash64;

/**
 * What the errors of techniques depend on besides depth, size and light: whether a cloud is finite, and its density.
 *
 * @param word as in the table, such as {@code layer cumulus}
 */
public record CloudForm(String word) {
    /** Returns the form of a cloud. */
    public static CloudForm of(Cloud cloud) {
        String extent = cloud.extent() instanceof Cloud.Extent.Layer ? "layer " : "volume ";
        return new CloudForm(extent + density(cloud.density()));
    }

    /** Returns the form of this very cloud, whatever its id, its technique and the allowed error. */
    public static CloudForm only(Cloud cloud) {
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
        return new CloudForm("cloud " + Long.toHexString(Hash64.of(LevelJson.line(same))));
    }

    private static String density(Density density) {
        if (density instanceof Density.Noise noise && noise.profile() != null) {
            return noise.profile().name().toLowerCase(Locale.ROOT);
        }
        return density.getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
