package nephele.editor.session;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.editor.save.DocumentFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** The document that New makes. */
public final class NewDocument {
    private NewDocument() {}

    /** Returns an untitled level with nothing in it but daylight; its assets are those of the working folder. */
    public static DocumentFile.Opened opened() {
        var sun = new Sun(new Vec3(-0.5, 0.75, 0.43), new Vec3(3.4, 3.1, 2.6), true);
        var sky = new Sky.Gradient(new Vec3(0.1, 0.24, 0.56), new Vec3(0.5, 0.6, 0.7), new Vec3(0.26, 0.24, 0.21));
        // Even light inside: a room without lamps is not black while it is built, and needs no bake.
        var inside = new Vec3(0.2, 0.22, 0.25);
        var environment = new Environment(sun, sky, inside, Exposure.NEUTRAL, ToneCurve.FILMIC, null, List.of());
        return new DocumentFile.Opened(
                DocumentFile.UNTITLED,
                Level.of("Untitled", "", environment, List.of()),
                LevelAssets.beside(Path.of("untitled.json")),
                Optional.empty());
    }
}
