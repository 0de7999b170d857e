package nephele.editor.save;

import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.json.AssetPlaces;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.GeneratedName;

/** Lists the files that a level needs: those that its records name, and those that these name. */
public final class NamedAssets {
    private NamedAssets() {}

    /** Returns the ids that a level's records name, sorted. */
    public static Set<String> of(Level level) {
        return new TreeSet<>(AssetPlaces.of(level).keySet());
    }

    /**
     * Returns the files that a level needs: without names from which a mesh is generated, and with the files that a mesh
     * names, such as the buffers of a glTF file.
     */
    public static Set<String> of(Level level, AssetSource assets) {
        Set<String> files = new TreeSet<>();
        for (String id : of(level)) {
            files.addAll(assets.exists(id) ? withNeighbours(id, assets) : generatedFrom(id, assets));
        }
        return files;
    }

    private static Set<String> withNeighbours(String id, AssetSource assets) {
        Set<String> files = new LinkedHashSet<>(Set.of(id));
        String name = id.toLowerCase(Locale.ROOT);
        if (!name.endsWith(".gltf") && !name.endsWith(".glb")) {
            return files;
        }
        try {
            ModelFiles.read(id, assets.bytes(id), noted(id, assets, files::add));
        } catch (ModelFileException | AssetException unusable) {
            // The level's check tells what is wrong with the mesh; what it asked for until then is known.
            return files;
        }
        return files;
    }

    /** Returns the files from which a mesh of this name is generated, or the name itself if none is. */
    private static Set<String> generatedFrom(String id, AssetSource assets) {
        Set<String> asked = new LinkedHashSet<>();
        try {
            if (GeneratedName.shape(id, noted(id, assets, asked::add)).isPresent()) {
                asked.removeIf(neighbour -> !assets.exists(neighbour));
                return asked;
            }
        } catch (ModelFileException wrongNumbers) {
            return Set.of(id);
        }
        return Set.of(id);
    }

    private static Function<String, byte[]> noted(String id, AssetSource assets, Consumer<String> asked) {
        Function<String, byte[]> besides = ModelFiles.besides(assets, id);
        String folder = id.substring(0, id.lastIndexOf('/') + 1);
        return name -> {
            asked.accept(folder + name);
            return besides.apply(name);
        };
    }
}
