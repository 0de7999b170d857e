package nephele.app.scenes;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.app.terminal.CommandFailure;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.Picture;
import nephele.engine.level.Level;
import nephele.engine.level.LevelRules;
import nephele.engine.level.Problem;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.render.fixed.SceneFolder;
import nephele.engine.xmlscene.LevelDraft;
import nephele.engine.xmlscene.LevelDraft.Part;
import nephele.engine.xmlscene.PosedScene;
import nephele.engine.xmlscene.XmlModel;
import nephele.engine.xmlscene.XmlScene;
import nephele.engine.xmlscene.XmlScene.XmlWarning;

/** An XML scene becomes a level with its files beside it. */
public final class SceneImport {
    private static final Vec3 WHITE = new Vec3(1, 1, 1);

    private final SceneName name;
    private final SceneFolder folder;
    private final ImportedFiles files;
    private final Consumer<String> complaints;
    private final Map<String, Vec3> tints = new HashMap<>();

    private SceneImport(SceneName name, Path target, Consumer<String> complaints) {
        this.name = name;
        this.complaints = complaints;
        AssetSource assets = name.assets();
        folder = new SceneFolder(name.typed(), assets, complaints);
        files = new ImportedFiles(assets, target);
    }

    /**
     * The level that a scene makes; its meshes and pictures are where that, saved as {@code target}, finds them.
     *
     * @param complaints takes a line for all that is odd or left out
     */
    public static Level level(SceneName name, Path target, Consumer<String> complaints) {
        try {
            return new SceneImport(name, target, complaints).wholeLevel(target);
        } catch (ModelFileException problem) {
            throw CommandFailure.input(problem.getMessage());
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
    }

    /** With all of its files, or else with none of them. */
    private Level wholeLevel(Path target) throws IOException {
        try {
            return level(target);
        } catch (IOException | RuntimeException failure) {
            files.takeBack();
            throw failure;
        }
    }

    private Level level(Path target) throws IOException {
        XmlScene scene = name.read();
        tell(scene.warnings());
        List<Part> parts = parts(PosedScene.of(scene));
        LevelDraft draft = LevelDraft.of(name.stem(), scene, parts);
        tell(draft.warnings());
        if (draft.level().models().isEmpty()) {
            throw CommandFailure.input(name.typed() + ":" + scene.root().line() + ": none of its models can be placed");
        }
        List<Problem> errors = LevelRules.check(draft.level(), LevelAssets.beside(target)).stream()
                .filter(Problem::isError)
                .toList();
        if (!errors.isEmpty()) {
            throw CommandFailure.input(
                    name.typed() + ": makes no level: " + errors.get(0).line(target.toString()));
        }
        return draft.level();
    }

    private void tell(List<XmlWarning> warnings) {
        warnings.forEach(warning -> tell(warning.line(), warning.message()));
    }

    private void tell(int line, String message) {
        complaints.accept(name.typed() + ":" + line + ": " + message);
    }

    private List<Part> parts(PosedScene posed) throws IOException {
        List<Part> parts = new ArrayList<>();
        for (int number = 0; number < posed.modelCount(); number++) {
            parts.add(part(posed.model(number)));
        }
        return parts;
    }

    /** {@code null} for one that cannot be shown, which has been told. */
    private Part part(XmlModel model) throws IOException {
        Mesh mesh = folder.mesh(model);
        if (mesh == null) {
            return null;
        }
        try {
            String file = files.mesh(model.file(), mesh);
            Picture picture = model.texture() == null ? null : folder.picture(model);
            if (picture == null) {
                return new Part(file, null, WHITE, box(mesh));
            }
            Vec3 tint = tints.computeIfAbsent(model.texture(), texture -> MeanColour.of(picture));
            return new Part(file, files.picture(model.texture()), tint, box(mesh));
        } catch (IllegalArgumentException tooLarge) {
            tell(model.line(), model.file() + ": " + tooLarge.getMessage());
            return null;
        }
    }

    private static Aabb box(Mesh mesh) {
        float[] p = mesh.positions();
        Aabb box = Aabb.EMPTY;
        for (int i = 0; i < p.length; i += 3) {
            box = box.union(new Aabb(p[i], p[i + 1], p[i + 2], p[i], p[i + 1], p[i + 2]));
        }
        return box;
    }
}
