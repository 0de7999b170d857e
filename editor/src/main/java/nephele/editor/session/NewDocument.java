package nephele.editor.session;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.editor.save.DocumentFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** The document that New makes. */
public final class NewDocument {
    private NewDocument() {}

    /** Returns an untitled level that has nothing but an even light; its assets are those of the working folder. */
    public static DocumentFile.Opened opened() {
        Vec3 light = new Vec3(0.5, 0.5, 0.5);
        Environment environment = new Environment(null, null, light, 0, ToneCurve.CLIP, null, List.of());
        return new DocumentFile.Opened(
                DocumentFile.UNTITLED,
                Level.of("Untitled", "", environment, List.of()),
                LevelAssets.beside(Path.of("untitled.json")),
                Optional.empty());
    }
}
