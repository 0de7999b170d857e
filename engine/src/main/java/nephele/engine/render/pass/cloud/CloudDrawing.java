package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;

/** The drawing of one cloud by some technique. */
public interface CloudDrawing {
    /** Takes the cloud and the light around it at the time of the frame. */
    void follow(Environment environment, CloudInterval now);

    /** Draws it over what is behind, premultiplied. */
    void draw(CloudCanvas canvas);
}
