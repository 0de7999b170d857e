package nephele.scenes.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.FileName;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.math.Vec3;
import nephele.engine.model.ModelFileException;
import nephele.host.terminal.CommandFailure;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.fixed.SceneFolder;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlScene;

/** A scene with its entity and background, read from files. */
public record OpenedScene(Sources sources) {
    private static final int MOST_BACKGROUND_BYTES = 64 << 20;

    /**
     * Opens a scene.
     *
     * @param entity {@code null} for none
     * @param background a file, or else an asset; {@code null} for none
     * @param complaints receives a line for each kind of oddity that is shown nevertheless, or left out
     */
    public static OpenedScene of(SceneName scene, SceneName entity, String background, Consumer<String> complaints) {
        var counted = new CountedWarnings();
        try {
            var shown = new OpenedScene(new Sources(
                    source(scene, counted),
                    entity == null ? null : source(entity, counted),
                    background == null ? null : picture(background, scene.assets(), counted)));
            warnOfDarkness(scene, shown.scene(), counted);
            return shown;
        } catch (ModelFileException problem) {
            throw CommandFailure.input(problem.getMessage());
        } finally {
            counted.report(complaints);
        }
    }

    /** Opens a scene as the game shows it; only the sample has an entity and a background. */
    public static OpenedScene ofGame(SceneName scene, Consumer<String> complaints) {
        return scene.equals(SceneName.SAMPLE)
                ? of(scene, SceneName.SAMPLE_ENTITY, SceneName.SAMPLE_BACKGROUND, complaints)
                : of(scene, null, null, complaints);
    }

    public XmlScene scene() {
        return sources.scene().scene();
    }

    private static Source source(SceneName name, Consumer<String> complaints) {
        XmlScene scene = name.read();
        scene.warnings()
                .forEach(warning -> complaints.accept(name.typed() + ":" + warning.line() + ": " + warning.message()));
        var files = new SceneFolder(name.typed(), name.assets(), complaints);
        requireModel(name, scene, files);
        return new Source(scene, files);
    }

    private static void warnOfDarkness(SceneName name, XmlScene scene, Consumer<String> complaints) {
        PosedScene posed = PosedScene.of(scene);
        boolean isDark = IntStream.range(0, posed.modelCount())
                .allMatch(model -> posed.firstLight(model) == PosedScene.NONE
                        && posed.model(model).colours().emissive().equals(Vec3.ZERO));
        if (isDark) {
            complaints.accept(name.typed() + ":" + scene.root().line() + ": it is dark, because no light reaches its"
                    + " models; add <lights><light"
                    + " type=\"directional\" dirx=\"1\" diry=\"2\""
                    + " dirz=\"3\"/></lights> to its root element");
        }
    }

    /** Rejects a scene without any model that can be shown; the reasons have been reported by then. */
    private static void requireModel(SceneName name, XmlScene scene, SceneFiles files) {
        PosedScene posed = PosedScene.of(scene);
        for (int number = 0; number < posed.modelCount(); number++) {
            if (files.mesh(posed.model(number)) != null) {
                return;
            }
        }
        throw CommandFailure.input(name.typed() + ":" + scene.root().line() + ": none of its models can be shown");
    }

    /** Returns the picture, or {@code null} if it cannot be read: the scene is shown without it. */
    private static Picture picture(String name, AssetSource assets, Consumer<String> complaints) {
        try {
            boolean isAsset =
                    !Files.exists(Path.of(name)) && AssetId.rejectionReason(name) == null && assets.exists(name);
            byte[] bytes = isAsset ? assets.bytes(name) : AtomicFile.read(Path.of(name), MOST_BACKGROUND_BYTES);
            return PictureDecoder.decode(name, bytes);
        } catch (IOException problem) {
            complaints.accept(name + ": can't be read: " + AtomicFile.reason(problem));
        } catch (AssetException problem) {
            complaints.accept(problem.getMessage());
        } catch (InvalidPathException problem) {
            complaints.accept(FileName.printable(name) + ": " + FileName.objection(name));
        }
        return null;
    }
}
