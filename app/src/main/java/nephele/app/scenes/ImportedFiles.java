package nephele.app.scenes;

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
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.WholeFile;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshText;

/**
 * A scene's meshes and pictures where a level finds them. What the level would find already, bit for bit, stays where it
 * is; the rest is written beside the level, under another name where one is taken.
 */
final class ImportedFiles {
    private final AssetSource from;
    private final AssetSource to;
    private final Path folder;
    private final Map<String, String> meshes = new HashMap<>();
    private final Map<String, String> pictures = new HashMap<>();
    private final List<Path> written = new ArrayList<>();
    private final List<Path> folders = new ArrayList<>();

    /** @param from where the scene finds its files */
    ImportedFiles(AssetSource from, Path level) {
        this.from = from;
        this.to = LevelAssets.beside(level);
        this.folder = level.toAbsolutePath().normalize().getParent();
    }

    /** Deletes what was written, and folders that were made for it: nobody can use it. */
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

    /** To be called before a file is written: remembers which of its folders are made for it. */
    void expect(Path file) {
        Path around = file.toAbsolutePath().normalize().getParent();
        for (Path at = around; at != null && !Files.exists(at); at = at.getParent()) {
            folders.add(at);
        }
    }

    /**
     * The asset id of a mesh, which is written when the scene's is a name only.
     *
     * @throws IllegalArgumentException when it is too large for a file
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
        WholeFile.write(file, bytes);
        return id;
    }

    /** A scene may name what no level may: a file of the folder above, or with spaces, or generated wherever it lies. */
    private static String allowed(String file) {
        String name = file.substring(file.lastIndexOf('/') + 1).replace(' ', '_');
        return AssetId.objection(file) == null ? file : name;
    }

    private boolean isTaken(String id) {
        return to.exists(id) || Files.exists(folder.resolve(id));
    }

    private static String stem(String file) {
        int dot = file.lastIndexOf('.');
        return dot <= file.lastIndexOf('/') ? file : file.substring(0, dot);
    }
}
