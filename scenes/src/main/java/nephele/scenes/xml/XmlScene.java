package nephele.scenes.xml;

import java.util.List;
import nephele.engine.asset.MessageText;
import nephele.engine.math.Vec3;

/**
 * A scene as its file states, with defaults for what is missing.
 *
 * @param lights lights of the whole scene: those of {@code <world>}; a {@code <scene>} has its own in groups
 * @param root contains everything; it has no steps of its own
 * @param warnings about parts that are unusual but shown, in the order of lines
 */
public record XmlScene(
        Dialect dialect, Window window, Eye eye, List<XmlLight> lights, XmlGroup root, List<XmlWarning> warnings) {
    /** The size of the window in pixels. */
    public record Window(int width, int height) {}

    /** @param fovDegrees vertical */
    public record Eye(Vec3 position, Vec3 lookAt, Vec3 up, double fovDegrees, double near, double far) {}

    /** @param line its line; the first is 1 */
    public record XmlWarning(int line, String message) {
        public XmlWarning {
            message = MessageText.shortened(message);
        }
    }
}
