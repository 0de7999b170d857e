package nephele.engine.reference.tile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/** The {@link BlockFile} that finished tiles are written to; what of it is cut off or damaged is traced again. */
public final class PartFile implements AutoCloseable {
    private final BlockFile blocks;
    private final String replaced;
    private int found;

    private PartFile(BlockFile blocks, String replaced) {
        this.blocks = blocks;
        this.replaced = replaced;
    }

    /**
     * Opens or creates the part of a picture and puts the tiles that it holds into the picture. A part of another picture
     * is replaced.
     *
     * @throws PartFileException if another run writes to it or it is no part file
     */
    public static PartFile open(Path path, PartHeader header, TiledPicture picture) throws IOException {
        BlockFile blocks = BlockFile.open(path);
        try {
            PartFile part = opened(path, blocks, header);
            part.restore(header.tiles(), picture);
            return part;
        } catch (IOException | RuntimeException failure) {
            blocks.close();
            throw failure;
        }
    }

    private static PartFile opened(Path path, BlockFile blocks, PartHeader header) throws IOException {
        if (blocks.isEmpty(header.text())) {
            blocks.begin(header.text());
            return new PartFile(blocks, null);
        }
        PartHeader known = blocks.head().map(PartHeader::parse).orElse(null);
        if (known == null) {
            throw new PartFileException(path, "is in the way and no part of a picture; delete or rename it");
        }
        String difference = header.difference(known);
        if (!known.shard().equals(header.shard())) {
            difference += (difference.isEmpty() ? "" : "; ") + "shard " + known.shard();
        }
        if (!difference.isEmpty()) {
            blocks.begin(header.text());
        }
        return new PartFile(blocks, difference.isEmpty() ? null : difference);
    }

    private void restore(PixelTiles tiles, TiledPicture picture) throws IOException {
        for (TilePixels pixels = next(blocks, tiles); pixels != null; pixels = next(blocks, tiles)) {
            found += picture.has(pixels.tile()) ? 0 : 1;
            picture.put(pixels);
        }
        blocks.truncate();
    }

    /** Returns the next tile; {@code null} if there is none or it is incomplete or damaged. */
    static TilePixels next(BlockFile blocks, PixelTiles tiles) throws IOException {
        return blocks.next((tile, values) -> tile >= 0
                        && tile < tiles.count()
                        && (values == 3 * tiles.pixels(tile) || values == 2 * 3 * tiles.pixels(tile)))
                .map(block -> {
                    int colours = 3 * tiles.pixels(block.number());
                    return new TilePixels(
                            block.number(),
                            Arrays.copyOf(block.values(), colours),
                            Arrays.copyOfRange(block.values(), colours, block.values().length));
                })
                .orElse(null);
    }

    /** Returns how many tiles were in the file. */
    public int found() {
        return found;
    }

    /** Returns how the picture differs whose part was replaced; empty if none was. */
    public Optional<String> replaced() {
        return Optional.ofNullable(replaced);
    }

    /** Writes a finished tile; may be called by any thread. */
    public void append(TilePixels pixels) throws IOException {
        float[] values = Arrays.copyOf(pixels.rgb(), pixels.rgb().length + pixels.variance().length);
        System.arraycopy(pixels.variance(), 0, values, pixels.rgb().length, pixels.variance().length);
        blocks.append(new BlockFile.Block(pixels.tile(), values));
    }

    /** Forces what is written to the disk and closes the file. */
    @Override
    public void close() throws IOException {
        blocks.close();
    }
}
