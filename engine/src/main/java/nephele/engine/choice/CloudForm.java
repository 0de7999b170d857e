package nephele.engine.choice;

import java.util.Locale;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density;

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

    private static String density(Density density) {
        if (density instanceof Density.Noise noise && noise.profile() != null) {
            return noise.profile().name().toLowerCase(Locale.ROOT);
        }
        return density.getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
