package nephele.scenes.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.Picture;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelSaveException;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import nephele.engine.rule.LevelRules;
import nephele.host.terminal.CommandFailure;
import nephele.scenes.fixed.SceneFolder;
import nephele.scenes.xml.LevelDraft;
import nephele.scenes.xml.LevelDraft.Part;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlScene;
import nephele.scenes.xml.XmlScene.XmlWarning;

/** Converts an XML scene to a level with its files beside it. */
public final class SceneImport {
    private static final double[] LINEAR = ColourDecoding.SRGB.table();

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
     * An imported level.
     *
     * @param written all files that were written, the level first
     */
    public record Imported(Level level, List<Path> written) {}

    /**
     * Saves the level made of a scene, with its meshes and pictures beside it, or nothing at all after a failure.
     *
     * @param complaints receives a line for each kind of oddity or omission
     */
    public static Imported save(SceneName name, Path target, Consumer<String> complaints) {
        var counted = new CountedWarnings();
        try {
            return save(name, target, new SceneImport(name, target, counted));
        } finally {
            counted.report(complaints);
        }
    }

    private static Imported save(SceneName name, Path target, SceneImport scene) {
        try {
            Level level = scene.saved(target);
            List<Path> written = new ArrayList<>(List.of(target));
            scene.files.written().forEach(file -> written.add(target.resolveSibling(file)));
            return new Imported(level, List.copyOf(written));
        } catch (ModelFileException problem) {
            throw CommandFailure.input(problem.getMessage());
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
    }

    private Level saved(Path target) throws IOException {
        boolean done = false;
        try {
            Level level = level(target);
            save(level, target);
            done = true;
            return level;
        } finally {
            if (!done) {
                files.takeBack();
            }
        }
    }

    private void save(Level level, Path target) {
        try {
            files.expect(target);
            Files.createDirectories(target.toAbsolutePath().getParent());
            LevelFile.save(target, level);
        } catch (IOException failure) {
            throw CommandFailure.environment(target + ": can't be written: " + AtomicFile.reason(failure), failure);
        } catch (LevelSaveException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        } catch (LevelFormatException wrong) {
            throw CommandFailure.input(name.typed() + ": makes no level: " + wrong.getMessage());
        }
    }

    private Level level(Path target) throws IOException {
        XmlScene scene = name.read();
        warn(scene.warnings());
        List<Part> parts = parts(PosedScene.of(scene), LevelDraft.placeable(scene));
        LevelDraft draft = LevelDraft.of(name.stem(), scene, parts);
        warn(draft.warnings());
        if (draft.level().models().isEmpty()) {
            throw CommandFailure.input(name.typed() + ":" + scene.root().line() + ": none of its models can be placed");
        }
        List<Problem> errors = LevelRules.checkRecordsAndFiles(draft.level(), LevelAssets.beside(target)).stream()
                .filter(Problem::isError)
                .toList();
        if (!errors.isEmpty()) {
            throw CommandFailure.input(
                    name.typed() + ": makes no level: " + errors.get(0).line(target.toString()));
        }
        return draft.level();
    }

    private void warn(List<XmlWarning> warnings) {
        warnings.forEach(warning -> warn(warning.line(), warning.message()));
    }

    private void warn(int line, String message) {
        complaints.accept(name.typed() + ":" + line + ": " + message);
    }

    /** @param placeable the indices of the models that the level can hold */
    private List<Part> parts(PosedScene posed, Set<Integer> placeable) throws IOException {
        List<Part> parts = new ArrayList<>();
        long triangles = 0;
        for (int number = 0; number < posed.modelCount(); number++) {
            XmlModel model = posed.model(number);
            Mesh mesh = folder.mesh(model);
            triangles += mesh == null || !placeable.contains(number) ? 0 : mesh.triangleCount();
            requireFew(model, triangles);
            parts.add(mesh == null ? null : part(model, mesh));
        }
        return parts;
    }

    /** Rejects too many triangles early: the level's rules would report it only after all meshes are made. */
    private void requireFew(XmlModel model, long triangles) {
        if (triangles > PlacedModels.MOST_TRIANGLES) {
            throw CommandFailure.input(name.typed() + ":" + model.line() + ": makes no level: with " + model.file()
                    + " its models have " + triangles + " triangles or more, of " + PlacedModels.MOST_TRIANGLES
                    + " that a level may have; place fewer models or coarser ones");
        }
    }

    /** Returns the part of a model, or {@code null} if it cannot be shown, which has been reported. */
    private Part part(XmlModel model, Mesh mesh) throws IOException {
        try {
            String file = files.mesh(model.file(), mesh);
            Picture picture = model.texture() == null ? null : folder.picture(model);
            if (picture == null) {
                return new Part(file, null, WHITE, box(mesh));
            }
            Vec3 tint = tints.computeIfAbsent(model.texture(), texture -> meanColour(picture));
            return new Part(file, files.picture(model.texture()), tint, box(mesh));
        } catch (IllegalArgumentException tooLarge) {
            warn(model.line(), model.file() + ": " + tooLarge.getMessage());
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

    /** Returns the mean colour in linear light. */
    private static Vec3 meanColour(Picture picture) {
        byte[] rgba = picture.toRgba8().samples();
        double[] sums = new double[3];
        for (int i = 0; i < rgba.length; i += 4) {
            for (int channel = 0; channel < 3; channel++) {
                sums[channel] += LINEAR[rgba[i + channel] & 0xff];
            }
        }
        double pixels = rgba.length / 4.0;
        return new Vec3(sums[0] / pixels, sums[1] / pixels, sums[2] / pixels);
    }
}
