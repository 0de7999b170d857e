package nephele.engine.reference.tile;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.engine.asset.AtomicFile;

/** Puts the parts of a picture together, whatever their order. */
public final class MergedParts {
    private final List<Part> parts = new ArrayList<>();

    private record Part(Path file, PartHeader header, List<TilePixels> tiles) {}

    private MergedParts() {}

    /**
     * Returns the picture.
     *
     * @throws PartFileException if a part is missing, incomplete, given twice or of another picture
     * @throws IOException if a file cannot be read
     */
    public static TiledPicture of(List<Path> files) throws IOException {
        MergedParts merged = new MergedParts();
        for (Path file : files) {
            merged.add(read(file));
        }
        return merged.picture();
    }

    private static Part read(Path path) throws IOException {
        try (BlockFile blocks = BlockFile.reading(path)) {
            PartHeader header = blocks.head().map(PartHeader::parse).orElse(null);
            if (header == null) {
                throw new PartFileException(path, "is no part of a picture; name what --shard wrote");
            }
            List<TilePixels> tiles = new ArrayList<>();
            TilePixels next = PartFile.next(blocks, header.tiles());
            while (next != null) {
                tiles.add(next);
                next = PartFile.next(blocks, header.tiles());
            }
            if (!blocks.isAtEnd()) {
                throw new PartFileException(
                        path,
                        "is cut off or damaged from byte " + blocks.end() + " on, after " + tiles.size()
                                + " tiles; run the command of this shard again, it goes on from there");
            }
            return new Part(path, header, tiles);
        } catch (NoSuchFileException missing) {
            throw new PartFileException(
                    path, "there is no such file; name the parts that --shard wrote, which end in .i-of-n.part");
        } catch (IOException unreadable) {
            throw new IOException(path + ": can't be read: " + AtomicFile.reason(unreadable), unreadable);
        }
    }

    private void add(Part part) {
        for (Part other : parts) {
            String difference = other.header.difference(part.header);
            if (!difference.isEmpty()) {
                throw new PartFileException(
                        part.file, "belongs to another picture than " + other.file + ": " + difference);
            }
            if (other.header.shard().of() != part.header.shard().of()) {
                throw new PartFileException(
                        part.file,
                        "is shard " + part.header.shard() + " and " + other.file + " is shard " + other.header.shard()
                                + "; merge shards of one division");
            }
            if (other.header.shard().equals(part.header.shard())) {
                throw new PartFileException(
                        part.file, "and " + other.file + " are both shard " + part.header.shard() + "; name one");
            }
        }
        parts.add(part);
    }

    private TiledPicture picture() {
        requireAll();
        PixelTiles all = parts.get(0).header.tiles();
        TiledPicture picture = new TiledPicture(all);
        for (Part part : parts) {
            part.tiles.forEach(picture::put);
            long missing = part.header
                    .shard()
                    .tiles(all)
                    .filter(tile -> !picture.has(tile))
                    .count();
            if (missing > 0) {
                throw new PartFileException(
                        part.file,
                        "lacks " + missing + " of its "
                                + part.header.shard().tiles(all).count()
                                + " tiles; run the command of this shard again, it goes on from there");
            }
        }
        return picture;
    }

    private void requireAll() {
        Shard first = parts.get(0).header.shard();
        String missing = IntStream.rangeClosed(1, first.of())
                .filter(number ->
                        parts.stream().noneMatch(part -> part.header.shard().number() == number))
                .mapToObj(number -> number + "/" + first.of())
                .limit(10)
                .collect(Collectors.joining(", "));
        if (!missing.isEmpty()) {
            throw new PartFileException(parts.get(0).file, "is one of " + first.of() + " shards; missing: " + missing);
        }
    }
}
