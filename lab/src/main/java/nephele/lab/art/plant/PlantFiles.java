package nephele.lab.art.plant;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.model.file.MeshText;
import nephele.lab.art.picture.PictureRecipe;

/** The files of plants and rocks that ship, one mesh a kind and the palette that all share. */
public final class PlantFiles {
    /** The meshes' folder below {@code assets/}. */
    public static final String FOLDER = "models/plants";

    public static final List<PictureRecipe> PICTURES = List.of(new PictureRecipe(PlantPaint.FILE, PlantPaint::palette));

    private static final long SEED = 1;

    private PlantFiles() {}

    /** Returns the meshes by asset id. */
    public static Map<String, byte[]> meshes() {
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (PlantKind kind : PlantKinds.ALL) {
            files.put(FOLDER + "/" + kind.word() + ".3d", MeshText.of(kind.grown(SEED)));
        }
        return files;
    }
}
