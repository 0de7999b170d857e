package nephele.scenes.xml;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.regex.Pattern;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.engine.model.ModelFileException;
import nephele.scenes.xml.XmlScene.XmlWarning;

/** Reads XML scenes of both dialects. Unusual input gives a warning, and everything that can be shown is included. */
public final class XmlSceneFile {
    public static final int MOST_BYTES = 8 << 20;
    public static final int MOST_NESTED_GROUPS = 10_000;

    /** Matches warnings of {@link XmlTree} and {@link ModelReader} about a model that is left out. */
    private static final Pattern COSTS_A_MODEL = Pattern.compile("^<model>: it names no file|^<models?> does not belong"
            + "|did you mean 'models?'|in <model>: skipped; did you mean 'file'");

    private XmlSceneFile() {}

    /** Reads a file. @throws ModelFileException if it cannot be read or contains nothing to show */
    public static XmlScene read(Path file) throws ModelFileException {
        try {
            return read(file.toString(), AtomicFile.read(file, MOST_BYTES));
        } catch (IOException problem) {
            String reason = "it can't be read: " + AtomicFile.reason(problem);
            throw new ModelFileException(file.toString(), 0, reason, "name an XML scene", problem);
        }
    }

    /**
     * Reads bytes.
     *
     * @param file its name in messages
     * @throws ModelFileException with the line, if nothing in it can be shown
     */
    public static XmlScene read(String file, byte[] utf8) throws ModelFileException {
        SceneWarnings remarks = new SceneWarnings(file);
        XmlElement tree = XmlTree.read(text(utf8, remarks), remarks);
        Dialect dialect = XmlTree.dialect(tree);
        XmlGroup root = new GroupReader(dialect, remarks).root(tree);
        if (!holdsModels(root)) {
            throw nothingToShow(tree, remarks);
        }
        if (dialect == Dialect.SCENE) {
            return new XmlScene(
                    dialect, EyeReader.SCENE_WINDOW, EyeReader.SCENE_EYE, List.of(), root, remarks.byLine());
        }
        EyeReader eyes = new EyeReader(remarks);
        XmlScene.Window window = eyes.window(tree);
        XmlScene.Eye eye = eyes.eye(tree);
        List<XmlLight> lights = new LightReader(remarks).ofWorld(tree);
        return new XmlScene(dialect, window, eye, lights, root, remarks.byLine());
    }

    private static boolean holdsModels(XmlGroup root) {
        var below = new ArrayDeque<XmlGroup>(List.of(root));
        while (!below.isEmpty()) {
            XmlGroup group = below.pop();
            if (!group.models().isEmpty()) {
                return true;
            }
            group.groups().forEach(below::push);
        }
        return false;
    }

    private static ModelFileException nothingToShow(XmlElement tree, SceneWarnings remarks) {
        List<XmlWarning> warnings = remarks.byLine();
        if (warnings.isEmpty()) {
            return remarks.error(tree.line(), "it holds no model", "add <models><model file=\"box_2_3.3d\"/></models>");
        }
        XmlWarning cause = warnings.stream()
                .filter(warning -> COSTS_A_MODEL.matcher(warning.message()).find())
                .findFirst()
                .orElse(warnings.get(0));
        return remarks.error(cause.line(), "it holds no model; " + cause.message(), "mend this first");
    }

    /** The text of a scene, without zero characters. */
    private static String text(byte[] bytes, SceneWarnings warnings) {
        if (bytes.length > MOST_BYTES) {
            int mebibytes = MOST_BYTES >> 20;
            throw warnings.error(0, "the file has more than " + mebibytes + " MiB", "split the scene");
        }
        try {
            String text = TextFile.text(bytes);
            int zero = text.indexOf('\0');
            if (zero >= 0) {
                int line = 1
                        + (int) text.chars().limit(zero).filter(c -> c == '\n').count();
                throw warnings.error(line, "the file holds zero bytes instead of text", "restore it");
            }
            return text;
        } catch (TextFile.NotUtf8 noText) {
            throw warnings.error(noText.line(), "it can't be read", noText.getMessage());
        }
    }
}
