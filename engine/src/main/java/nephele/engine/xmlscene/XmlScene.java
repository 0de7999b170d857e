package nephele.engine.xmlscene;

import java.util.List;
import nephele.engine.asset.MessageText;
import nephele.engine.math.Vec3;

/**
 * A scene as its file says, with what the file leaves out filled in.
 *
 * @param lights of the whole scene: those of {@code <world>}; a {@code <scene>} has its own in groups
 * @param root holds everything; it has no steps of its own
 * @param warnings what was odd and shown all the same, in the order of lines
 */
public record XmlScene(
        Dialect dialect, Window window, Eye eye, List<XmlLight> lights, XmlGroup root, List<XmlWarning> warnings) {
    /** In pixels. */
    public record Window(int width, int height) {}

    /** @param fovDegrees vertical */
    public record Eye(Vec3 position, Vec3 lookAt, Vec3 up, double fovDegrees, double near, double far) {}

    /** @param line where; the first is 1 */
    public record XmlWarning(int line, String message) {
        public XmlWarning {
            message = MessageText.shortened(message);
        }
    }
}
