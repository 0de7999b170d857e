package nephele.app.scenes;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import nephele.app.terminal.CommandFailure;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.WholeFile;
import nephele.engine.model.ModelFileException;
import nephele.engine.render.fixed.FixedSceneDrawing.Source;
import nephele.engine.render.fixed.FixedSceneDrawing.Sources;
import nephele.engine.render.fixed.SceneFolder;
import nephele.engine.xmlscene.XmlScene;
import nephele.engine.xmlscene.XmlSceneFile;

/** A scene with its entity and background, read from files. */
public record OpenedScene(Sources sources) {
    private static final int MOST_BACKGROUND_BYTES = 64 << 20;

    /**
     * @param entity {@code null} for none
     * @param background {@code null} for none
     * @param complaints takes a line for all that is odd and shown all the same, or left out
     */
    public static OpenedScene of(Path scene, Path entity, Path background, Consumer<String> complaints) {
        try {
            return new OpenedScene(new Sources(
                    source(scene, complaints),
                    entity == null ? null : source(entity, complaints),
                    background == null ? null : picture(background, complaints)));
        } catch (ModelFileException problem) {
            throw CommandFailure.input(problem.getMessage());
        }
    }

    public XmlScene scene() {
        return sources.scene().scene();
    }

    private static Source source(Path file, Consumer<String> complaints) {
        XmlScene scene = XmlSceneFile.read(file);
        scene.warnings().forEach(warning -> complaints.accept(file + ":" + warning.line() + ": " + warning.message()));
        return new Source(scene, new SceneFolder(file.toString(), LevelAssets.beside(file), complaints));
    }

    /** {@code null} where it cannot be shown: the scene can all the same. */
    private static Picture picture(Path file, Consumer<String> complaints) {
        try {
            return PictureDecoder.decode(file.toString(), WholeFile.read(file, MOST_BACKGROUND_BYTES));
        } catch (IOException problem) {
            complaints.accept(file + ": can't be read: " + WholeFile.reason(problem));
        } catch (AssetException problem) {
            complaints.accept(problem.getMessage());
        }
        return null;
    }
}
