package nephele.engine.level.placed;

import java.util.Optional;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.GeneratedName;
import nephele.engine.model.shape.Shape;

/** The meshes behind asset ids: files, or generated shapes if the id names one. */
public final class MeshAssets {
    private final AssetSource assets;

    public MeshAssets(AssetSource assets) {
        this.assets = assets;
    }

    /**
     * Returns the mesh.
     *
     * @throws AssetException if there is none, or the file cannot be used
     */
    public Mesh mesh(String assetId) {
        return mesh(assetId, note -> {});
    }

    /**
     * Returns the mesh, as {@link #mesh(String)} does.
     *
     * @param notes receives warnings about the file, which begin with its name
     */
    public Mesh mesh(String assetId, Consumer<String> notes) {
        try {
            return assets.exists(assetId) ? ModelFiles.read(assetId, assets, notes) : generated(assetId);
        } catch (ModelFileException problem) {
            String where = problem.line() > 0 ? problem.file() + ":" + problem.line() : problem.file();
            throw new AssetException(where, problem.reason(), problem.remedy(), problem);
        }
    }

    private Mesh generated(String assetId) {
        Optional<Shape> named = GeneratedName.shape(assetId, ModelFiles.besides(assets, assetId));
        Shape shape = named.orElseThrow(() -> new AssetException(
                assetId,
                "there is no such file, and the generator makes none of that name",
                "put it into the level's folder or into assets/"));
        if (shape.maxTriangles() > PlacedModels.MOST_TRIANGLES) {
            throw new AssetException(
                    assetId,
                    "stands for " + shape.maxTriangles() + " triangles, of " + PlacedModels.MOST_TRIANGLES
                            + " that a level may have",
                    "write smaller numbers of parts into the name");
        }
        return shape.mesh();
    }
}
