package nephele.scenes.file;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ProjectAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.model.ModelFileException;
import nephele.host.terminal.CommandFailure;
import nephele.scenes.xml.XmlScene;
import nephele.scenes.xml.XmlSceneFile;

/** The name of a scene as a user types it: a file, or else a scene of the jar such as {@code scenes/lighthouse.xml}. */
public record SceneName(String typed) {
    public static final SceneName SAMPLE = new SceneName("scenes/solar-system.xml");
    public static final SceneName SAMPLE_ENTITY = new SceneName("scenes/ship.xml");
    /** The id of an asset. */
    public static final String SAMPLE_BACKGROUND = "textures/scenes/stars.png";

    private static final String JAR_SCENES = "/scenes";

    /** Returns the title: the file name {@code solar-system.xml} gives "Solar system". */
    public String title() {
        String words = stem().replace('-', ' ');
        return words.isEmpty() ? typed : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    /** Returns the file's name without folder and extension. */
    public String stem() {
        String name = typed.substring(Math.max(typed.lastIndexOf('/'), typed.lastIndexOf('\\')) + 1);
        return name.replaceFirst("\\.[xX][mM][lL]$", "");
    }

    /** @throws ModelFileException if the scene cannot be read or holds nothing to show */
    XmlScene read() {
        return isInJar() ? XmlSceneFile.read(typed, jar().bytes(inScenes())) : XmlSceneFile.read(path());
    }

    /** Returns the source to which the names of its models and pictures are relative. */
    AssetSource assets() {
        return isInJar() ? LevelAssets.inJar(JAR_SCENES, inScenes()) : ProjectAssets.around(path());
    }

    private boolean isInJar() {
        return !Files.exists(path()) && AssetId.rejectionReason(inScenes()) == null && jar().exists(inScenes());
    }

    private static AssetSource jar() {
        return new ResourceAssets(JAR_SCENES);
    }

    private String inScenes() {
        return typed.replace('\\', '/').replaceFirst("^(\\./)?scenes/", "");
    }

    private Path path() {
        try {
            return Path.of(typed);
        } catch (InvalidPathException noPath) {
            throw CommandFailure.input(FileName.printable(typed) + ": " + FileName.objection(typed));
        }
    }
}
