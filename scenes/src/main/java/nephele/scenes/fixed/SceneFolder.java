package nephele.scenes.fixed;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.GeneratedName;
import nephele.scenes.xml.XmlModel;

/**
 * The files beside a scene, each read once. A missing mesh is generated if its name is one of the generator's. Each
 * file that cannot be shown gives one warning, with the first line that refers to it.
 */
public final class SceneFolder implements SceneFiles {
    /** Upper bounds of all meshes and of all pictures; a larger scene would not fit on a graphics card. */
    private static final long MOST_VERTICES = 16L << 20;

    private static final long MOST_PIXELS = 128L << 20;

    private final String sceneFile;
    private final AssetSource assets;
    private final Consumer<String> complaints;
    private final Map<String, Optional<Mesh>> meshes = new HashMap<>();
    private final Map<String, Optional<Picture>> pictures = new HashMap<>();
    private long vertices;
    private long pixels;

    /**
     * @param sceneFile its name in warnings
     * @param assets names in the scene are relative to its folder
     */
    public SceneFolder(String sceneFile, AssetSource assets, Consumer<String> complaints) {
        this.sceneFile = sceneFile;
        this.assets = assets;
        this.complaints = complaints;
    }

    @Override
    public Mesh mesh(XmlModel model) {
        return meshes.computeIfAbsent(model.file(), file -> found(model, () -> readMesh(model, file)))
                .orElse(null);
    }

    @Override
    public Picture picture(XmlModel model) {
        return pictures.computeIfAbsent(model.texture(), file -> found(model, () -> readPicture(file)))
                .orElse(null);
    }

    private <T> Optional<T> found(XmlModel model, Supplier<T> read) {
        try {
            return Optional.of(read.get());
        } catch (ModelFileException | AssetException problem) {
            complaints.accept(sceneFile + ":" + model.line() + ": " + problem.getMessage());
            return Optional.empty();
        }
    }

    private Mesh readMesh(XmlModel model, String file) {
        Mesh mesh = assets.exists(file)
                ? ModelFiles.read(file, assets, note -> complaints.accept(sceneFile + ":" + model.line() + ": " + note))
                : generated(file);
        if (vertices + mesh.vertexCount() > MOST_VERTICES) {
            throw new ModelFileException(
                    file, 0, "the scene's meshes have more than " + MOST_VERTICES + " vertices", "use smaller ones");
        }
        vertices += mesh.vertexCount();
        return mesh;
    }

    private Mesh generated(String file) {
        return GeneratedName.shape(file, ModelFiles.besides(assets, file))
                .orElseThrow(() -> missing(file))
                .mesh();
    }

    private Picture readPicture(String file) {
        if (!assets.exists(file)) {
            throw missing(file);
        }
        Picture picture = PictureDecoder.decode(file, assets.bytes(file));
        long size = (long) picture.width() * picture.height();
        if (pixels + size > MOST_PIXELS) {
            throw new AssetException(
                    file, "the scene's pictures have more than " + MOST_PIXELS + " pixels", "use smaller ones");
        }
        pixels += size;
        return picture;
    }

    /** A file whose name is not a valid asset id may exist, but is not looked up. */
    private AssetException missing(String file) {
        String objection = assets.objection(file);
        if (objection != null) {
            return new AssetException(
                    file,
                    "has a name that is not allowed: " + objection,
                    "write a path within the scene's folder or the one above, of letters, digits, spaces, '.', '_', '-'"
                            + " and '/'");
        }
        return new AssetException(
                file, "there is no such file", "put it into the scene's folder (names are case-sensitive)");
    }
}
