package nephele.engine.model.file;

import com.google.gson.JsonObject;
import de.javagl.jgltf.model.GltfModel;
import de.javagl.jgltf.model.GltfModels;
import de.javagl.jgltf.model.io.v2.GltfAssetV2;
import de.javagl.jgltf.model.io.v2.GltfReaderV2;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.ModelText;

/**
 * Reads glTF 2.0. The parts that a mesh needs are validated first, every count against the bytes present. Only these
 * parts are passed to the library, so that no file can make it allocate too much or follow an address.
 */
final class GltfFile {
    private final String file;
    private final byte[] bytes;
    private final Function<String, byte[]> neighbour;

    /** @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none */
    GltfFile(String file, byte[] bytes, Function<String, byte[]> neighbour) {
        this.file = file;
        this.bytes = bytes;
        this.neighbour = neighbour;
    }

    Mesh read() {
        GltfContainer container = GltfContainer.of(file, bytes);
        GltfValue root = new GltfJson(file, container.json()).read();
        checkVersion(root);
        GltfBuffers buffers = GltfBuffers.of(root.member("buffers"), container.binary(), neighbour);
        JsonObject checked = new GltfScene(root, buffers).checked();
        return new GltfTriangles(file, library(checked, buffers)).mesh();
    }

    private static void checkVersion(GltfValue root) {
        GltfValue version = root.member("asset").member("version");
        if (!version.text("").startsWith("2.")) {
            throw version.error("is not 2.0", "export the mesh as glTF 2.0");
        }
        for (GltfValue extension : root.member("extensionsRequired").elements()) {
            String name = extension.text("");
            if (!name.startsWith("KHR_materials_") && !name.equals("KHR_texture_transform")) {
                throw extension.error(
                        "is " + ModelText.quoted(name) + ", which can't be read", "export without compression");
            }
        }
    }

    private GltfModel library(JsonObject checked, GltfBuffers buffers) {
        try {
            byte[] json = checked.toString().getBytes(StandardCharsets.UTF_8);
            var reader = new GltfReaderV2();
            reader.setJsonErrorConsumer(error -> {});
            var data = ByteBuffer.wrap(buffers.bytes()).order(ByteOrder.LITTLE_ENDIAN);
            return GltfModels.create(new GltfAssetV2(reader.read(new ByteArrayInputStream(json)), data));
        } catch (IOException | RuntimeException problem) {
            throw new ModelFileException(file, 0, "can't be understood as glTF", "export the mesh again", problem);
        }
    }
}
