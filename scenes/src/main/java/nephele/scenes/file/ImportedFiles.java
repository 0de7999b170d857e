package nephele.scenes.file;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.model.Mesh;
import nephele.engine.model.file.MeshText;

/**
 * Makes a scene's meshes and pictures available to a level. A file that the level already finds with identical bytes is
 * shared. The rest is written beside the level, under another name if the name is taken.
 */
final class ImportedFiles {
    private final AssetSource from;
    private final AssetSource to;
    private final Path folder;
    private final Map<String, String> meshes = new HashMap<>();
    private final Map<String, String> pictures = new HashMap<>();
    private final List<Path> written = new ArrayList<>();
    private final List<Path> folders = new ArrayList<>();

    /** @param from the source of the scene's files */
    ImportedFiles(AssetSource from, Path level) {
        this.from = from;
        this.to = LevelAssets.beside(level);
        this.folder = level.toAbsolutePath().normalize().getParent();
    }

    /** Returns all written files, by their names beside the level. */
    List<Path> written() {
        return written.stream().map(folder::relativize).toList();
    }

    /** Deletes all written files, and the folders made for them, after a failure. */
    void takeBack() throws IOException {
        for (Path file : written) {
            Files.deleteIfExists(file);
        }
        folders.sort(Comparator.comparingInt(Path::getNameCount).reversed());
        for (Path made : folders) {
            try {
                Files.deleteIfExists(made);
            } catch (DirectoryNotEmptyException usedByOthers) {
                continue;
            }
        }
    }

    /** Remembers which folders have to be made for a file; called before it is written. */
    void expect(Path file) {
        Path around = file.toAbsolutePath().normalize().getParent();
        for (Path at = around; at != null && !Files.exists(at); at = at.getParent()) {
            folders.add(at);
        }
    }

    /**
     * Returns the asset id of a mesh. The mesh is written if the level does not find the scene's file.
     *
     * @throws IllegalArgumentException if it is too large for a file
     */
    String mesh(String file, Mesh mesh) throws IOException {
        String known = meshes.get(file);
        if (known == null) {
            known = isShared(file) ? file : written(stem(allowed(file)) + ".3d", MeshText.of(mesh));
            meshes.put(file, known);
        }
        return known;
    }

    String picture(String file) throws IOException {
        String known = pictures.get(file);
        if (known == null) {
            known = isShared(file) ? file : written(allowed(file), from.bytes(file));
            pictures.put(file, known);
        }
        return known;
    }

    private boolean isShared(String id) {
        return from.exists(id) && to.exists(id) && Arrays.equals(from.bytes(id), to.bytes(id));
    }

    private String written(String wanted, byte[] bytes) throws IOException {
        String id = wanted;
        for (int number = 2; isTaken(id); number++) {
            if (to.exists(id) && Arrays.equals(to.bytes(id), bytes)) {
                return id;
            }
            id = stem(wanted) + "-" + number + wanted.substring(stem(wanted).length());
        }
        AssetId.check(id);
        Path file = folder.resolve(id);
        expect(file);
        written.add(file);
        AtomicFile.write(file, bytes);
        return id;
    }

    /**
     * Returns a file name that a level may use: a scene may name a file of the folder above, one with spaces or a
     * generated mesh.
     */
    private static String allowed(String file) {
        String name = file.substring(file.lastIndexOf('/') + 1).replace(' ', '_');
        return AssetId.rejectionReason(file) == null ? file : name;
    }

    private boolean isTaken(String id) {
        return to.exists(id) || Files.exists(folder.resolve(id));
    }

    private static String stem(String file) {
        int dot = file.lastIndexOf('.');
        return dot <= file.lastIndexOf('/') ? file : file.substring(0, dot);
    }
}
