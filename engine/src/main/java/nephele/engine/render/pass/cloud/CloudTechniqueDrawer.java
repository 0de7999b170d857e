package nephele.engine.render.pass.cloud;

import java.util.function.Function;
import nephele.engine.level.CloudTechnique;

/** A way to draw clouds: what the clouds of a level that are drawn so share. */
public interface CloudTechniqueDrawer {
    /** Returns the drawing of a cloud. */
    CloudDrawing of(PlacedCloud cloud);

    /** The one constant of a technique. */
    record Registered(CloudTechnique technique, Function<CloudContext, CloudTechniqueDrawer> build) {}
}
