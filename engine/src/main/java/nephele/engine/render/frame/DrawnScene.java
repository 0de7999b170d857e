package nephele.engine.render.frame;

import java.util.List;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.CloudTechnique;
import nephele.engine.model.BoundingSphere;
import nephele.engine.scene.Scene;

/**
 * A scene with what was decided about it before it is drawn.
 *
 * @param clouds those of its environment
 * @param techniques the technique that draws each cloud; none is auto
 * @param eyes bounds all places of an eye; {@code null} if it can be anywhere, or if no technique depends on it
 */
public record DrawnScene(Scene scene, LoadedClouds clouds, List<CloudTechnique> techniques, BoundingSphere eyes) {
    public DrawnScene {
        techniques = List.copyOf(techniques);
    }
}
