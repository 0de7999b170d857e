package nephele.lab.bake;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import nephele.engine.bake.LightBake;
import nephele.engine.reference.tile.BlockFile;
import nephele.engine.reference.tile.PartFileException;

/** The finished blocks of a bake of light, in a file: an interrupted bake goes on from those that are on disk. */
public final class LightCheckpoint implements LightBake.Checkpoint, AutoCloseable {
    private static final String FIRST_LINE = "nephele-light 1\n";

    private final Path path;
    private final BlockFile file;
    private final Map<Integer, float[]> known = new ConcurrentHashMap<>();

    private LightCheckpoint(Path path, BlockFile file) {
        this.path = path;
        this.file = file;
    }

    /**
     * Opens or creates the file; one of another bake is emptied.
     *
     * @param facts what the bake depends on, in a line
     * @param blocks their number
     * @throws PartFileException if another run writes to it, or it is another kind of file
     */
    public static LightCheckpoint open(Path path, String facts, int blocks) throws IOException {
        BlockFile file = BlockFile.open(path);
        try {
            LightCheckpoint opened = new LightCheckpoint(path, file);
            opened.read(FIRST_LINE + facts + "\n\n", blocks);
            return opened;
        } catch (IOException | RuntimeException failure) {
            file.close();
            throw failure;
        }
    }

    private void read(String head, int blocks) throws IOException {
        boolean isOurs = file.isEmpty(head)
                || file.head().filter(text -> text.startsWith(FIRST_LINE)).isPresent();
        if (!isOurs) {
            throw new PartFileException(path, "is in the way and no part of a bake; delete or rename it");
        }
        if (!file.head().equals(Optional.of(head))) {
            file.begin(head);
            return;
        }
        BlockFile.Possible isPossible = (number, values) -> number >= 0 && number < blocks;
        var next = file.next(isPossible);
        while (next.isPresent()) {
            known.put(next.get().number(), next.get().values());
            next = file.next(isPossible);
        }
        file.truncate();
    }

    /** Returns how many blocks are finished. */
    public int found() {
        return known.size();
    }

    @Override
    public Optional<float[]> known(int block) {
        return Optional.ofNullable(known.get(block));
    }

    @Override
    public void store(int block, float[] values) {
        try {
            file.append(new BlockFile.Block(block, values));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Closes and deletes the file of a bake that is finished. */
    public void forget() throws IOException {
        close();
        Files.deleteIfExists(path);
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
