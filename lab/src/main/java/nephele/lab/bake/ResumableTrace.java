package nephele.lab.bake;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.tile.PartFile;
import nephele.engine.reference.tile.PartHeader;
import nephele.engine.reference.tile.TilePixels;
import nephele.engine.reference.tile.TiledPicture;
import nephele.host.terminal.PrintedProgress;

/**
 * Traces pictures of one level, or shards of them, into a part file each: an interrupted run goes on from the tiles that
 * are on disk.
 *
 * @param log receives progress
 */
public record ResumableTrace(List<Part> parts, PrintStream log) {
    /**
     * A picture or a shard of it.
     *
     * @param file that holds its tiles
     * @param header says which picture it is
     */
    public record Part(Path file, PartHeader header, Pinhole eye) {
        /** Deletes the part file of a picture that is finished. */
        public void forget() throws IOException {
            Files.deleteIfExists(file);
        }

        private int tiles() {
            return (int) header.shard().tiles(header.tiles()).count();
        }
    }

    /**
     * Returns the pictures when all tiles of their shards are in the files.
     *
     * @param settings with the size of each picture
     * @throws nephele.engine.reference.tile.PartFileException if a file is in use or no part
     * @throws IOException if a file cannot be written
     */
    public List<TiledPicture> run(TracedLevel level, TraceSettings settings) throws IOException {
        List<Open> open = new ArrayList<>();
        try {
            for (Part part : parts) {
                open.add(new Open(part));
            }
            traceLeft(level, settings, open);
        } catch (IllegalStateException stopped) {
            if (stopped.getCause() instanceof UncheckedIOException unwritten) {
                throw unwritten.getCause();
            }
            throw stopped;
        } finally {
            close(open);
        }
        return open.stream().map(part -> part.picture).toList();
    }

    private static void close(List<Open> open) throws IOException {
        for (Open part : open) {
            part.file.close();
        }
    }

    /** A part whose file is locked, with the tiles that were in it. */
    private static final class Open {
        private final Part part;
        private final TiledPicture picture;
        private final PartFile file;

        Open(Part part) throws IOException {
            this.part = part;
            picture = new TiledPicture(part.header.tiles());
            file = PartFile.open(part.file, part.header, picture);
        }

        int[] left() {
            return part.header
                    .shard()
                    .tiles(part.header.tiles())
                    .filter(tile -> !picture.has(tile))
                    .toArray();
        }

        void put(TilePixels pixels) {
            try {
                file.append(pixels);
            } catch (IOException failure) {
                throw new UncheckedIOException(failure);
            }
            picture.put(pixels);
        }
    }

    /** Traces the tiles that are not in the files. */
    private void traceLeft(TracedLevel level, TraceSettings settings, List<Open> open) {
        int count = parts.stream().mapToInt(Part::tiles).sum();
        int found = open.stream().mapToInt(part -> part.file.found()).sum();
        double before = (double) found / count;
        for (Open part : open) {
            part.file
                    .replaced()
                    .ifPresent(difference -> log.println(part.part.file + " was of another picture: " + difference));
        }
        if (found > 0) {
            log.println("resumed at " + (int) (100 * before) + " %");
        }
        var progress = PrintedProgress.ofTrace(log, before);
        var done = new AtomicInteger(found);
        long pixels = 0;
        long start = System.nanoTime();
        for (Open part : open) {
            int[] left = part.left();
            pixels += IntStream.of(left)
                    .mapToLong(part.part.header.tiles()::pixels)
                    .sum();
            ReferencePicture.tiles(level, part.part.eye, settings, IntStream.of(left), tile -> {
                part.put(tile);
                progress.accept((double) done.incrementAndGet() / count);
            });
        }
        reportSpeed(pixels * settings.samples(), settings.threads(), (System.nanoTime() - start) / 1e9);
    }

    private void reportSpeed(long paths, int threads, double seconds) {
        if (paths > 0) {
            log.println(String.format(
                    Locale.ROOT,
                    "%,d paths by %d threads in %.1f s: %,.0f a second",
                    paths,
                    threads,
                    seconds,
                    paths / seconds));
        }
    }
}
