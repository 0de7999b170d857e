package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.field.PuffFilling;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.level.Cloud;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.scene.View;

/**
 * Counts the pixels of clouds that are where they should be: each value of such a pixel is one of those that the right picture
 * has up to a pixel away, or between them. Looks at every fourth pixel along both sides that has an optical depth above 0.01.
 */
final class PixelTolerance {
    private static final int STEP = 4;
    private static final double LEAST_DEPTH = 0.01;
    /** Difference of display values that nobody sees. */
    private static final double CODE = 1 / 255.0;

    private final List<PuffsField> fields = new ArrayList<>();
    private long pixels;
    private long inside;

    /** @param clouds those of puffs count */
    PixelTolerance(List<Cloud> clouds) {
        for (Cloud cloud : clouds) {
            if (cloud.density() instanceof Cloud.Density.Puffs puffs
                    && cloud.extent() instanceof Cloud.Extent.Volume volume) {
                fields.add(new PuffsField(PuffFilling.all(puffs), volume.centre(), cloud.extinctionPerMetre()));
            }
        }
    }

    void add(View view, LinearPicture reference, LinearPicture seen) {
        for (int y = 1; y < reference.height() - 1; y += STEP) {
            for (int x = 1; x < reference.width() - 1; x += STEP) {
                if (depth(view, reference, x, y) > LEAST_DEPTH) {
                    pixels++;
                    inside += isInside(reference, seen, x, y) ? 1 : 0;
                }
            }
        }
    }

    private double depth(View view, LinearPicture picture, int x, int y) {
        double right = ((2 * x + 1.0) / picture.width() - 1) * view.projection().tanHalfWidth();
        double up = ((2 * y + 1.0) / picture.height() - 1) * view.projection().tanHalfHeight();
        Vec3 towards = view.right().scaled(right).addScaled(up, view.up()).minus(view.back());
        Ray ray = Ray.of(view.eye(), towards.scaled(1 / towards.length()));
        double depth = 0;
        for (PuffsField field : fields) {
            depth += field.closedDepth(ray, 0, Double.POSITIVE_INFINITY).orElseThrow();
        }
        return depth;
    }

    private static boolean isInside(LinearPicture reference, LinearPicture seen, int x, int y) {
        for (int channel = 0; channel < 3; channel++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int j = -1; j <= 1; j++) {
                for (int i = -1; i <= 1; i++) {
                    double value = display(reference, x + i, y + j, channel);
                    least = Math.min(least, value);
                    most = Math.max(most, value);
                }
            }
            double value = display(seen, x, y, channel);
            if (value < least - CODE || value > most + CODE) {
                return false;
            }
        }
        return true;
    }

    /** Returns what a display is sent, 0 to 1. */
    private static double display(LinearPicture picture, int x, int y, int channel) {
        return Math.pow(picture.rgb()[3 * (picture.width() * y + x) + channel], 1 / 2.2);
    }

    long pixels() {
        return pixels;
    }

    double fraction() {
        return (double) inside / pixels;
    }
}
