package nephele.workshop.prove.picture;

import java.util.stream.IntStream;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.VisibleSurface;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import nephele.lab.bake.TracedPictures;

/**
 * The surfaces that the exact twin sees, in identity colours, bottom row first: one ray in the middle of each pixel,
 * and more rays for pixels in doubt.
 */
final class SightPicture {
    /** Rays along each side of the three by three pixels around a pixel in doubt: first few, then many. */
    private static final int[] FINER = {15, 127};

    private final TracedLevel level;
    private final Pinhole eye;
    private final int width;
    private final int height;
    private final int[] rgb;
    private final long[] passed;

    SightPicture(TracedLevel level, View view, int width, int height) {
        this.level = level;
        this.width = width;
        this.height = height;
        eye = TracedPictures.pinhole(view);
        rgb = new int[width * height];
        passed = new long[width * height];
        IntStream.range(0, height).parallel().forEach(this::row);
    }

    private void row(int row) {
        VisibleSurface sight = level.sight(eye);
        for (int column = 0; column < width; column++) {
            int pixel = row * width + column;
            int surface = sight.at((column + 0.5) / width, (row + 0.5) / height);
            rgb[pixel] = surface == VisibleSurface.NOTHING ? 0 : IdLevel.colour(surface);
            passed[pixel] = sight.pathHash();
        }
    }

    int height() {
        return height;
    }

    /** Returns the colour at the middle of a pixel. */
    int at(int column, int row) {
        return rgb[row * width + column];
    }

    /**
     * Returns true if every pixel of the three by three around this one shows the same surface through the same
     * portals, so that no edge is near, not even that of an opening behind which the same floor continues.
     */
    boolean isPlain(int column, int row) {
        int middle = row * width + column;
        for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
            for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
                int pixel = y * width + x;
                if (rgb[pixel] != rgb[middle] || passed[pixel] != passed[middle]) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * Returns true if some ray within one pixel of a pixel's middle hits the colour's surface or one that coincides
     * with it.
     */
    boolean shows(int colour, int column, int row) {
        for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
            for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
                if (at(x, y) == colour) {
                    return true;
                }
            }
        }
        VisibleSurface sight = level.sight(eye);
        int surface = IdLevel.surface(colour);
        for (int rays : FINER) {
            for (int i = 0; i < rays * rays; i++) {
                double x = column + 0.5 + 2.0 * (i % rays) / (rays - 1) - 1;
                double y = row + 0.5 + 2.0 * (i / rays) / (rays - 1) - 1;
                if (sight.at(x / width, y / height) == surface || sight.coincides(surface)) {
                    return true;
                }
            }
        }
        return false;
    }
}
