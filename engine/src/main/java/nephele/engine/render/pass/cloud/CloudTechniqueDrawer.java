package nephele.engine.render.pass.cloud;

import java.util.function.Function;
import java.util.function.Predicate;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.level.CloudTechnique;

/** A way to draw clouds: what the clouds of a level that are drawn so share. */
public interface CloudTechniqueDrawer {
    /** Returns the drawing of a cloud. */
    CloudDrawing of(PlacedCloud cloud);

    /**
     * The one constant of a technique.
     *
     * @param canShow false for clouds that it cannot draw
     */
    record Registered(
            CloudTechnique technique,
            Predicate<CloudSource> canShow,
            Function<CloudContext, CloudTechniqueDrawer> build) {}
}
