package nephele.engine.model.file;

import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.work.SwingThread;

/** Reads meshes by the extension of their file name. */
public final class ModelFiles {
    private ModelFiles() {}

    /**
     * Reads a mesh.
     *
     * @see #read(String, byte[], Function, Consumer)
     */
    public static Mesh read(String file, byte[] bytes, Function<String, byte[]> neighbour) {
        return read(file, bytes, neighbour, note -> {});
    }

    /**
     * Reads a mesh.
     *
     * @param file its name, which decides the format: .3d, .obj, .gltf or .glb
     * @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none
     * @param notes receives warnings, which begin with the file's name
     * @throws ModelFileException if the file is malformed, too large or of unknown format
     */
    public static Mesh read(String file, byte[] bytes, Function<String, byte[]> neighbour, Consumer<String> notes) {
        SwingThread.refuse("reading a model");
        String name = file.toLowerCase(Locale.ROOT);
        if (name.endsWith(".3d")) {
            return new TextMeshFile(file, bytes).read();
        }
        if (name.endsWith(".obj")) {
            return new ObjFile(file, bytes).read();
        }
        if (name.endsWith(".gltf") || name.endsWith(".glb")) {
            return new GltfFile(file, bytes, neighbour).read(notes);
        }
        throw new ModelFileException(file, 0, "is no mesh that can be read", "use .3d, .obj, .gltf or .glb");
    }

    /**
     * Reads a mesh from a source.
     *
     * @param notes receives warnings, which begin with the file's name
     * @throws ModelFileException if the file is malformed, too large or of unknown format
     * @throws AssetException if the source does not have it
     */
    public static Mesh read(String file, AssetSource assets, Consumer<String> notes) {
        Function<String, byte[]> besides = besides(assets, file);
        return read(
                file,
                assets.bytes(file),
                name -> {
                    requireName(name, assets.objection(folder(file) + name));
                    return besides.apply(name);
                },
                notes);
    }

    /**
     * Tells why a file that a mesh names is not looked up.
     *
     * @param objection {@code null} for a name that may be
     * @throws AssetException if there is one
     */
    public static void requireName(String name, String objection) {
        if (objection != null) {
            throw new AssetException(
                    name,
                    "is not looked up: " + objection,
                    "rename the file, with letters from a to z, digits, '.', '_' and '-'");
        }
    }

    private static String folder(String file) {
        return file.substring(0, file.lastIndexOf('/') + 1);
    }

    /** Returns a reader of files in the same folder as a file; it returns {@code null} for missing files. */
    public static Function<String, byte[]> besides(AssetSource assets, String file) {
        String folder = folder(file);
        return name -> assets.exists(folder + name) ? assets.bytes(folder + name) : null;
    }
}
