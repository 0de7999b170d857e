package nephele.editor.terrain;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import nephele.editor.save.ContentHash;
import nephele.editor.save.NamedAssets;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;

/**
 * The maps that strokes make. While a stroke goes on, its map is in memory under a name of its own; at the end it becomes
 * a new file beside the level, named by its content, so that undo, the journal and backups find every older one
 * unchanged. Maps in memory may be asked for on any thread.
 */
public final class PaintedMaps {
    private static final String FOLDER = "terrain/";
    private static final int MOST_KNOWN = 3;
    private static final int HASH_DIGITS = 12;

    private final Supplier<Optional<Path>> levelFile;
    /** The latest maps by their ids. */
    private final Map<String, PaintedMap> known = new LinkedHashMap<>();
    /** The files of this session's maps by their ids. */
    private final Map<String, Path> written = new HashMap<>();
    /** Files of maps that no saved level names. */
    private final Set<Path> unsaved = new LinkedHashSet<>();

    /** Ids of maps that are not forgotten, because a picture of them is being drawn. */
    private Set<String> drawn = Set.of();

    private long strokeNumber;

    /** @param levelFile the level's, empty if it was never saved */
    public PaintedMaps(Supplier<Optional<Path>> levelFile) {
        this.levelFile = levelFile;
    }

    /** Returns a level's files and the maps in memory. */
    public AssetSource over(AssetSource files) {
        return new PaintedAssets(this, files);
    }

    /** Returns true if there is a folder for the maps. */
    public boolean canKeep() {
        return levelFile.get().isPresent();
    }

    /**
     * Keeps the maps that a level names until another level is drawn: its picture is drawn on another thread, while the
     * stroke goes on.
     */
    public synchronized void drawing(Level level) {
        drawn = level.terrains().stream().map(Terrain::heightMap).collect(Collectors.toCollection(LinkedHashSet::new));
        level.terrains().stream().map(Terrain::layerMap).forEach(drawn::add);
    }

    /** Keeps a map in memory until a few others have been shown; returns its id. */
    synchronized String show(PaintedMap map) {
        strokeNumber++;
        return remember(FOLDER + "stroke-" + strokeNumber + ".png", map);
    }

    private String remember(String id, PaintedMap map) {
        known.remove(id);
        known.put(id, map);
        known.keySet().stream()
                .filter(other -> !drawn.contains(other))
                .limit(Math.max(0, known.size() - MOST_KNOWN))
                .toList()
                .forEach(known::remove);
        return id;
    }

    synchronized Optional<PaintedMap> known(String id) {
        return Optional.ofNullable(known.get(id));
    }

    /**
     * Writes a map to a file of its own, unless there is one of the same content; returns its id.
     *
     * @param beginning of the file's name
     * @throws IOException if it cannot be written; nothing has changed then
     */
    String keep(String beginning, PaintedMap map) throws IOException {
        Path level = levelFile.get().orElseThrow(() -> new IOException("the level has no folder yet"));
        byte[] content = map.file().get();
        String name = beginning.replaceAll("[^A-Za-z0-9_-]", "-");
        String id = FOLDER + name + "-" + ContentHash.of(content).substring(0, HASH_DIGITS) + ".png";
        Path file = level.resolveSibling(id);
        if (!Files.exists(file)) {
            AtomicFile.write(file, content);
            unsaved.add(file);
            written.put(id, file);
        }
        synchronized (this) {
            return remember(id, map);
        }
    }

    /** Notes that a level was saved: this session's maps that it names stay, and are copied to a level elsewhere. */
    public void saved(Level level) {
        Optional<Path> saved = levelFile.get();
        if (written.isEmpty() || saved.isEmpty()) {
            return;
        }
        for (String id : NamedAssets.of(level)) {
            Path file = written.get(id);
            if (file != null) {
                unsaved.remove(file);
                copy(file, saved.get().resolveSibling(id));
            }
        }
    }

    private static void copy(Path file, Path place) {
        try {
            if (!Files.exists(place)) {
                AtomicFile.copy(file, place);
            }
        } catch (IOException missing) {
            // The check of the level names the file that is missing beside it; the map itself stays where it is.
            return;
        }
    }

    /** Deletes the files that only unsaved edits have named, because nobody wants these any more. */
    public void discard() {
        for (Path file : unsaved) {
            try {
                Files.deleteIfExists(file);
            } catch (IOException stays) {
                // A file too many does no harm.
                continue;
            }
        }
        unsaved.clear();
    }

    /**
     * A map that a stroke has made.
     *
     * @param decoded what its file decodes to
     * @param file makes the file
     */
    record PaintedMap(Object decoded, Supplier<byte[]> file) {
        static PaintedMap of(HeightMap map) {
            return new PaintedMap(map, () -> map.png());
        }

        static PaintedMap of(LayerMap map) {
            return new PaintedMap(map, () -> map.png());
        }
    }
}
