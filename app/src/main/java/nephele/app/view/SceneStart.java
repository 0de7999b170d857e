package nephele.app.view;

import nephele.app.scenes.OpenedScene;
import nephele.engine.render.fixed.SceneLook;
import org.joml.Matrix4dc;

/**
 * What a viewer begins with.
 *
 * @param seconds what the scene's clock says then
 */
public record SceneStart(OpenedScene opened, SceneLook look, double seconds) {
    /** Where an entity rests before the scene's own camera. */
    public Matrix4dc worldFromEntity() {
        return viewing().place().worldFromEntity();
    }

    Viewing viewing() {
        var eye = opened.scene().eye();
        boolean hasEntity = opened.sources().entity() != null;
        return hasEntity ? Viewing.towing(eye, look, seconds) : Viewing.alone(eye, look, seconds);
    }
}
