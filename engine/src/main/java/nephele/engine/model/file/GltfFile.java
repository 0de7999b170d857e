package nephele.engine.model.file;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelText;

/**
 * Reads glTF 2.0: the triangles of the shown scene. Every count is validated against limits and the bytes present before
 * anything of its size is made, so that no file can make it allocate too much, and no address is followed.
 */
final class GltfFile {
    /** Beginnings of the names of extensions that change no triangles: of materials, textures and lights. */
    private static final List<String> WITHOUT_EFFECT =
            List.of("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_");

    private static final List<String> SERVED = List.of(GltfAccessors.QUANTIZATION);

    private final String file;
    private final byte[] bytes;
    private final Function<String, byte[]> neighbour;

    /** @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none */
    GltfFile(String file, byte[] bytes, Function<String, byte[]> neighbour) {
        this.file = file;
        this.bytes = bytes;
        this.neighbour = neighbour;
    }

    /** @param notes receives one warning if the mesh differs from what the file asks for */
    Mesh read(Consumer<String> notes) {
        GltfContainer container = GltfContainer.of(file, bytes);
        GltfValue root = new GltfJson(file, container.json()).read();
        checkVersion(root);
        GltfBuffers buffers = GltfBuffers.of(root.member("buffers"), container.binary(), neighbour);
        GltfScene scene = new GltfScene(root, buffers);
        Mesh mesh = scene.mesh();
        if (!scene.skipped().isEmpty()) {
            notes.accept(file + ": its " + String.join(" and ", scene.skipped())
                    + " are not applied, the mesh is shown as it is stored; export it in the pose to be shown");
        }
        return mesh;
    }

    private static void checkVersion(GltfValue root) {
        GltfValue version = root.member("asset").member("version");
        if (!version.text("").startsWith("2.")) {
            throw version.error("is not 2.0", "export the mesh as glTF 2.0");
        }
        for (GltfValue extension : root.member("extensionsRequired").elements()) {
            String name = extension.text("");
            if (WITHOUT_EFFECT.stream().noneMatch(name::startsWith) && !SERVED.contains(name)) {
                throw extension.error(
                        "is " + ModelText.quoted(name) + ", which can't be read",
                        name.contains("compression") ? "export without compression" : "export without it");
            }
        }
    }
}
