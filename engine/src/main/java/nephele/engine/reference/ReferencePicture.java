package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.reference.SampleSequence.PixelSample;
import nephele.engine.reference.SampleSequence.Point;
import nephele.engine.reference.tile.PixelMean;
import nephele.engine.reference.tile.PixelTiles;
import nephele.engine.reference.tile.TilePixels;
import nephele.engine.reference.tile.TiledPicture;
import org.joml.Vector3d;

/**
 * Traces a picture, tile by tile on several threads; the result depends neither on their number nor on which tiles are
 * traced together.
 */
public final class ReferencePicture {
    /** Raise it whenever a picture of any level changes: traced pictures are stored under it. */
    public static final int VERSION = 4;

    private static final Point MIDDLE = new Point(0.5, 0.5);

    private final TracedLevel level;
    private final Pinhole eye;
    private final TraceSettings settings;
    private final PixelTiles division;
    private final int[] tiles;
    private final Consumer<TilePixels> finished;
    private final SampleSequence sequence;
    private final AtomicInteger next = new AtomicInteger();

    private ReferencePicture(
            TracedLevel level, Pinhole eye, TraceSettings settings, int[] tiles, Consumer<TilePixels> finished) {
        this.level = level;
        this.eye = eye;
        this.settings = settings;
        this.tiles = tiles;
        this.finished = finished;
        division = settings.tiles();
        sequence = new SampleSequence(settings.seed());
    }

    /**
     * Returns linear radiance before exposure, RGB, the bottom row first.
     *
     * @param progress receives the completed fraction, 0–1, from any thread
     */
    public static float[] trace(TracedLevel level, Pinhole eye, TraceSettings settings, DoubleConsumer progress) {
        return picture(level, eye, settings, progress).rgb();
    }

    /**
     * Returns the picture with its standard error.
     *
     * @param progress receives the completed fraction, 0–1, from any thread
     */
    public static TiledPicture picture(
            TracedLevel level, Pinhole eye, TraceSettings settings, DoubleConsumer progress) {
        TiledPicture picture = new TiledPicture(settings.tiles());
        int count = settings.tiles().count();
        AtomicInteger done = new AtomicInteger();
        tiles(level, eye, settings, IntStream.range(0, count), pixels -> {
            picture.put(pixels);
            progress.accept((double) done.incrementAndGet() / count);
        });
        return picture;
    }

    /**
     * Traces some tiles of a picture.
     *
     * @param finished receives each tile, from any thread; what it throws ends the work
     */
    public static void tiles(
            TracedLevel level, Pinhole eye, TraceSettings settings, IntStream tiles, Consumer<TilePixels> finished) {
        new ReferencePicture(level, eye, settings, tiles.toArray(), finished).run();
    }

    private void run() {
        ExecutorService threads = Executors.newFixedThreadPool(settings.threads());
        try {
            List<Callable<Void>> workers = new ArrayList<>();
            for (int i = 0; i < settings.threads(); i++) {
                workers.add(this::work);
            }
            for (Future<Void> worker : threads.invokeAll(workers)) {
                worker.get();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("tracing was interrupted", stopped);
        } catch (ExecutionException failure) {
            throw new IllegalStateException("tracing failed: " + failure.getCause(), failure.getCause());
        } finally {
            threads.shutdownNow();
        }
    }

    private Void work() {
        Tracer tracer = level.tracer(eye, settings);
        PixelMean mean = new PixelMean(settings.samples());
        for (int i = next.getAndIncrement(); i < tiles.length; i = next.getAndIncrement()) {
            finished.accept(tile(tracer, tiles[i], mean));
        }
        return null;
    }

    private TilePixels tile(Tracer tracer, int tile, PixelMean mean) {
        float[] rgb = new float[3 * division.pixels(tile)];
        float[] variance = new float[mean.hasVariance() ? rgb.length : 0];
        for (int pixel = 0; pixel < division.pixels(tile); pixel++) {
            int column = division.left(tile) + pixel % division.width(tile);
            int row = division.bottom(tile) + pixel / division.width(tile);
            trace(tracer, column, row, mean);
            mean.putMean(rgb, 3 * pixel);
            if (mean.hasVariance()) {
                mean.putVariance(variance, 3 * pixel);
            }
        }
        return new TilePixels(tile, rgb, variance);
    }

    /** Traces samples over the square of the pixel. */
    private void trace(Tracer tracer, int column, int row, PixelMean mean) {
        mean.reset();
        for (int i = 0; i < settings.samples(); i++) {
            PixelSample sample = sequence.sample(column, row, i);
            Point in = settings.samples() == 1 ? MIDDLE : sample.inPixel();
            Vector3d direction =
                    eye.direction((column + in.x()) / settings.width(), (row + in.y()) / settings.height());
            mean.add(tracer.radiance(direction, sample));
        }
    }
}
