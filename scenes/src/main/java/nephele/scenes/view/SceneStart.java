package nephele.scenes.view;

import nephele.scenes.file.OpenedScene;
import nephele.scenes.fixed.SceneAppearance;
import org.joml.Matrix4dc;

/**
 * The initial state of a viewer.
 *
 * @param seconds the scene's initial clock
 */
public record SceneStart(OpenedScene opened, SceneAppearance look, double seconds) {
    /** Returns the transform of an entity at rest before the scene's own camera. */
    public Matrix4dc worldFromEntity() {
        return viewing().place().worldFromEntity();
    }

    /** Returns the viewer at rest. */
    public ViewerState viewing() {
        var eye = opened.scene().eye();
        boolean hasEntity = opened.sources().entity() != null;
        return hasEntity ? ViewerState.towing(eye, look, seconds) : ViewerState.alone(eye, look, seconds);
    }
}
