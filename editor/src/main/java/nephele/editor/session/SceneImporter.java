package nephele.editor.session;

import java.nio.file.Path;
import java.util.function.Consumer;

/** Converts XML scenes to levels. */
@FunctionalInterface
public interface SceneImporter {
    /**
     * Writes the level of a scene with its meshes and pictures beside it, or nothing at all after a failure.
     *
     * @param complaints receives a line for each thing that a level can't hold
     * @throws FileRefusal if the scene can't be read or makes no level
     */
    void save(Path scene, Path level, Consumer<String> complaints) throws FileRefusal;
}
