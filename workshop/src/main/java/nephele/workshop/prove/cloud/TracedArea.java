package nephele.workshop.prove.cloud;

import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.tile.PixelTiles;
import nephele.engine.reference.tile.TilePixels;
import nephele.engine.reference.tile.TiledPicture;

/**
 * A part of the picture of a case, traced, with its standard error.
 *
 * @param left column of its first pixel in the whole picture
 * @param bottom row of it, counted from below
 */
record TracedArea(ReferenceCase scene, int left, int bottom, TiledPicture picture) {
    /** Traces the whole picture on all processors. */
    static TracedArea whole(ReferenceCase scene, int samples, long seed, DoubleConsumer progress) {
        return new TracedArea(
                scene,
                0,
                0,
                ReferencePicture.picture(scene.level(), scene.eye(), settings(scene, samples, seed), progress));
    }

    /** Traces one of the tiles of the picture; its error is smoothed within it. */
    static TracedArea tile(ReferenceCase scene, int tile, int samples, long seed) {
        TraceSettings settings = settings(scene, samples, seed);
        PixelTiles all = settings.tiles();
        TiledPicture alone = new TiledPicture(new PixelTiles(all.width(tile), all.height(tile)));
        ReferencePicture.tiles(
                scene.level(),
                scene.eye(),
                settings,
                IntStream.of(tile),
                pixels -> alone.put(new TilePixels(0, pixels.rgb(), pixels.variance())));
        return new TracedArea(scene, all.left(tile), all.bottom(tile), alone);
    }

    private static TraceSettings settings(ReferenceCase scene, int samples, long seed) {
        return new TraceSettings(
                scene.radiance().width(),
                scene.radiance().height(),
                samples,
                seed,
                Runtime.getRuntime().availableProcessors());
    }

    int pixels() {
        return picture.tiles().width() * picture.tiles().height();
    }

    /** Returns the index of one of its pixels in the whole picture. */
    int inWhole(int pixel) {
        int width = picture.tiles().width();
        return (bottom + pixel / width) * scene.radiance().width() + left + pixel % width;
    }
}
