package nephele.editor.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;

/** The folder of a level's own assets, into which files from elsewhere are copied. */
final class AssetFolder {
    private static final int MOST_BYTES = 128 << 20;

    private final Path folder;
    private final LevelAssets assets;

    private AssetFolder(Path levelFile) {
        folder = levelFile.getParent();
        assets = LevelAssets.beside(levelFile);
    }

    /**
     * Returns the folder of the open level.
     *
     * @throws EditorRefusal if the level has no file yet
     */
    static AssetFolder of(EditorSession session, Path dropped) throws EditorRefusal {
        return new AssetFolder(session.file()
                .path()
                .orElseThrow(() -> new EditorRefusal(FileText.SAVE_FIRST.with(dropped.getFileName()))));
    }

    static byte[] read(Path file) throws EditorRefusal {
        try {
            return AtomicFile.read(file, MOST_BYTES);
        } catch (IOException unreadable) {
            throw new EditorRefusal(FileText.UNUSABLE.with(file, AtomicFile.reason(unreadable)));
        }
    }

    /** Returns the asset id of a file, as {@link #idOf(Path, byte[], String, Map)}, that names no other file. */
    String idOf(Path file, byte[] content, String subfolder) throws EditorRefusal {
        return idOf(file, content, subfolder, Map.of());
    }

    /**
     * Returns the asset id of a file: its own if it is an asset of the level already, otherwise that of a copy beside
     * the level. A copy never replaces a file; one of the same content is used.
     *
     * @param subfolder of copies, such as {@code textures}
     * @param neighbours contents of the files that it names beside itself, by their names; copied with it
     */
    String idOf(Path file, byte[] content, String subfolder, Map<String, byte[]> neighbours) throws EditorRefusal {
        Optional<String> known = knownId(file);
        if (known.isPresent()) {
            return known.get();
        }
        Map<String, byte[]> copies = new LinkedHashMap<>();
        for (Map.Entry<String, byte[]> neighbour : neighbours.entrySet()) {
            String id = subfolder + "/" + neighbour.getKey();
            if (AssetId.rejectionReason(id) != null || isTaken(id, neighbour.getValue())) {
                throw new EditorRefusal(FileText.NEIGHBOUR_TAKEN.with(file, folder.resolve(id)));
            }
            copies.put(id, neighbour.getValue());
        }
        String id = freeId(file.getFileName().toString(), content, subfolder);
        copies.put(id, content);
        for (Map.Entry<String, byte[]> copy : copies.entrySet()) {
            write(copy.getKey(), copy.getValue());
        }
        return id;
    }

    private String freeId(String name, byte[] content, String subfolder) {
        int dot = name.lastIndexOf('.');
        String stem = safe(name.substring(0, dot));
        String ending = name.substring(dot).toLowerCase(Locale.ROOT);
        String id = subfolder + "/" + stem + ending;
        for (int number = 2; isTaken(id, content); number++) {
            id = subfolder + "/" + stem + "-" + number + ending;
        }
        return id;
    }

    private void write(String id, byte[] content) throws EditorRefusal {
        Path place = folder.resolve(id);
        try {
            if (!Files.exists(place)) {
                Files.createDirectories(place.getParent());
                AtomicFile.write(place, content);
            }
        } catch (IOException unwritable) {
            throw new EditorRefusal(FileText.UNUSABLE.with(place, AtomicFile.reason(unwritable)));
        }
    }

    /** Returns the id under which the level finds this very file. */
    private Optional<String> knownId(Path file) {
        Path absolute = file.toAbsolutePath().normalize();
        for (int from = absolute.getNameCount() - 1; from >= 0; from--) {
            String id =
                    absolute.subpath(from, absolute.getNameCount()).toString().replace('\\', '/');
            Optional<Path> found = AssetId.rejectionReason(id) == null
                    ? assets.places(id).stream().filter(Files::exists).findFirst()
                    : Optional.empty();
            if (found.filter(absolute::equals).isPresent()) {
                return Optional.of(id);
            }
        }
        return Optional.empty();
    }

    private boolean isTaken(String id, byte[] content) {
        Path place = folder.resolve(id);
        try {
            // A directory or an unreadable file takes the name, too.
            return Files.exists(place) && !Arrays.equals(Files.readAllBytes(place), content);
        } catch (IOException unreadable) {
            return true;
        }
    }

    private static String safe(String stem) {
        String plain = stem.replaceAll("[^A-Za-z0-9_.]+", "-").replaceAll("^[-.]+|[-.]+$", "");
        String named = plain.isEmpty() ? "file" : plain.substring(0, Math.min(60, plain.length()));
        return AssetId.rejectionReason(named) == null ? named : "file-" + named;
    }
}
