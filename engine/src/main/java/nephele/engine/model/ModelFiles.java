package nephele.engine.model;

import java.util.Locale;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;

/** Meshes by the ending of their file's name. */
public final class ModelFiles {
    private ModelFiles() {}

    /**
     * Reads a mesh.
     *
     * @param neighbour the bytes of a file beside this one, {@code null} when there is none
     * @throws ModelFileException whatever is wrong with the file
     */
    public static Mesh read(String file, byte[] bytes, Function<String, byte[]> neighbour) {
        String name = file.toLowerCase(Locale.ROOT);
        if (name.endsWith(".3d")) {
            return new TextMeshFile(file, bytes).read();
        }
        if (name.endsWith(".obj")) {
            return new ObjFile(file, bytes).read();
        }
        if (name.endsWith(".gltf") || name.endsWith(".glb")) {
            return new GltfFile(file, bytes, neighbour).read();
        }
        throw new ModelFileException(file, 0, "is no mesh that can be read", "use .3d, .obj, .gltf or .glb");
    }

    /** What lies in the same folder as a file; {@code null} where nothing does. */
    public static Function<String, byte[]> besides(AssetSource assets, String file) {
        String folder = file.substring(0, file.lastIndexOf('/') + 1);
        return name -> assets.exists(folder + name) ? assets.bytes(folder + name) : null;
    }
}
