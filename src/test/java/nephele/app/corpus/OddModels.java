package nephele.app.corpus;

import static nephele.app.corpus.OddLevel.floorAnd;
import static nephele.app.corpus.OddLevel.many;
import static nephele.app.corpus.OddLevel.model;
import static nephele.app.corpus.OddLevel.scale;
import static nephele.app.corpus.OddLevel.seen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.model.MeshTexts;

/** Levels with models at the limits of the mesh file formats. */
final class OddModels {
    static final List<OddLevel> ALL = List.of(
            models("a model larger than the world", model("m", "sphere_1_8_8.3d", scale("[2e7, 2e7, 2e7]"))),
            models("a model around the player", model("m", "sphere_1_8_8.3d", scale("[1e6, 1e6, 1e6]"))),
            models(
                    "models inside out, as small as nothing, needles, the same ones, polygons",
                    model("inside", "sphere_1_8_8.3d", scale("[-1, 1, 1]")) + ", "
                            + model("nothing", "sphere_1_8_8.3d", scale("[1e-8, 1e-8, 1e-8]")) + ", "
                            + model("needle", "sphere_1_8_8.3d", scale("[1e-3, 1e3, 1e-3]")) + ", "
                            + many(50, i -> model("t" + i, "torus_1_0.3_8_6.3d", "")) + ", "
                            + model("l", "l.obj", "") + ", " + model("backslash", "backslash.obj", "") + ", "
                            + model("polygon", "polygon.obj", "")),
            models(
                    "models that have no area",
                    model("line", "line.3d", "") + ", " + model("zero", "zero.gltf", "") + ", "
                            + model("sheet", "box_1_1.3d", scale("[1e6, 1e-6, 1]"))),
            seen("one model that has no area", "\"models\": [" + model("line", "line.3d", "") + "]"));

    /** A polygon that is not convex. */
    private static final String L_SHAPE = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n";

    private OddModels() {}

    /** Writes the meshes that the levels name into a folder. */
    static void write(Path folder) throws IOException {
        Files.writeString(folder.resolve("l.obj"), L_SHAPE);
        Files.writeString(folder.resolve("backslash.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\");
        Files.writeString(folder.resolve("polygon.obj"), MeshTexts.polygon(4096));
        Files.writeString(folder.resolve("line.3d"), MeshTexts.LINE);
        Files.writeString(folder.resolve("zero.gltf"), MeshTexts.ZERO_GLTF);
    }

    private static OddLevel models(String name, String models) {
        return seen(name, floorAnd("") + ", \"models\": [" + models + "]");
    }
}
