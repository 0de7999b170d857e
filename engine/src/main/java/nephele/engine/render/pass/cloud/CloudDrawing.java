package nephele.engine.render.pass.cloud;

import java.util.function.BiFunction;
import java.util.function.Predicate;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.scene.View;

/** The drawing of one cloud by some technique. */
public interface CloudDrawing {
    /**
     * The one constant of a technique.
     *
     * @param canDraw false for clouds that it cannot draw
     * @param build makes the drawing of a cloud
     */
    record Technique(
            CloudTechnique technique,
            Predicate<CloudSource> canDraw,
            BiFunction<CloudContext, PlacedCloud, CloudDrawing> build) {}

    /** Takes the cloud and the light around it at the time of the frame. */
    void follow(Environment environment, CloudInterval now);

    /**
     * Draws what it keeps besides the view's pixels, before any cloud of the view is drawn. Target, limits and view of the
     * following draws are as before afterwards, but for the bound target.
     */
    default void prepare(View view) {}

    /** Draws it over what is behind, premultiplied. */
    void draw(CloudCanvas canvas);
}
