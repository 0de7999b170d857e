package nephele.lab.oracle;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.tile.PartFile;
import nephele.engine.reference.tile.PartHeader;
import nephele.engine.reference.tile.PixelTiles;
import nephele.engine.reference.tile.TilePixels;
import nephele.engine.reference.tile.TiledPicture;
import nephele.engine.terminal.PrintedProgress;

/**
 * Traces a picture, or a shard of it, into a part file: an interrupted run goes on from the tiles that are on disk.
 *
 * @param header says which picture it is
 * @param tell receives progress
 */
public record ResumableTrace(Path file, PartHeader header, PrintStream tell) {
    /**
     * Returns the picture when all tiles of the shard are in the file.
     *
     * @throws nephele.engine.reference.tile.PartFileException if the file is in use or no part
     * @throws IOException if it cannot be written
     */
    public TiledPicture run(TracedLevel level, Pinhole eye, TraceSettings settings) throws IOException {
        PixelTiles tiles = header.tiles();
        TiledPicture picture = new TiledPicture(tiles);
        try (PartFile part = PartFile.open(file, header, picture)) {
            int count = (int) header.shard().tiles(tiles).count();
            double before = (double) part.found() / count;
            part.replaced().ifPresent(difference -> tell.println(file + " was of another picture: " + difference));
            if (part.found() > 0) {
                tell.println("resumed at " + (int) (100 * before) + " %");
            }
            int[] left = header.shard()
                    .tiles(tiles)
                    .filter(tile -> !picture.has(tile))
                    .toArray();
            var progress = PrintedProgress.ofTrace(tell, before);
            AtomicInteger done = new AtomicInteger(part.found());
            long start = System.nanoTime();
            ReferencePicture.tiles(level, eye, settings, IntStream.of(left), pixels -> {
                append(part, pixels);
                picture.put(pixels);
                progress.accept((double) done.incrementAndGet() / count);
            });
            tellSpeed(left, settings, (System.nanoTime() - start) / 1e9);
            return picture;
        } catch (IllegalStateException stopped) {
            if (stopped.getCause() instanceof UncheckedIOException unwritten) {
                throw unwritten.getCause();
            }
            throw stopped;
        }
    }

    private static void append(PartFile part, TilePixels pixels) {
        try {
            part.append(pixels);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private void tellSpeed(int[] traced, TraceSettings settings, double seconds) {
        long paths =
                IntStream.of(traced).map(header.tiles()::pixels).asLongStream().sum() * settings.samples();
        if (paths > 0) {
            tell.println(String.format(
                    Locale.ROOT,
                    "%,d paths by %d threads in %.1f s: %,.0f a second",
                    paths,
                    settings.threads(),
                    seconds,
                    paths / seconds));
        }
    }

    /** Deletes the part file of a picture that is finished. */
    public void forget() throws IOException {
        Files.deleteIfExists(file);
    }
}
