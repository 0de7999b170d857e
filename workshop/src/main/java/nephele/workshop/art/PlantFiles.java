package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.model.file.MeshText;
import nephele.lab.generate.PlantKind;
import nephele.lab.generate.PlantKinds;
import nephele.lab.generate.PlantPaint;
import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.picture.PictureRecipe;

/** The files of plants and rocks that ship, one mesh a kind and the palette that all share. */
public final class PlantFiles {
    /** The meshes' folder below {@code assets/}. */
    public static final String FOLDER = "models/plants";

    public static final List<PictureRecipe> PICTURES = List.of(new PictureRecipe(PlantPaint.FILE, PlantFiles::palette));

    private static final long SEED = 1;
    private static final int SIDE_TEXELS = 128;

    private PlantFiles() {}

    private static BufferedImage palette() {
        PlantPaint[] all = PlantPaint.values();
        return Pixels.picture(SIDE_TEXELS, SIDE_TEXELS, (column, row) -> {
            PlantPaint paint = all[Math.min(row * PlantPaint.ROWS / SIDE_TEXELS, all.length - 1)];
            double place = ((column + 0.5) / SIDE_TEXELS - PlantPaint.MARGIN) / (1 - 2 * PlantPaint.MARGIN);
            return ColourRamp.of(paint.darkToLight()).at(Math.max(0, place)).rgb();
        });
    }

    /** Returns the meshes by asset id. */
    public static Map<String, byte[]> meshes() {
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (PlantKind kind : PlantKinds.ALL) {
            files.put(FOLDER + "/" + kind.word() + ".3d", MeshText.of(kind.grown(SEED)));
        }
        return files;
    }
}
