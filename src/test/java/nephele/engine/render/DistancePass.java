package nephele.engine.render;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.Texture;

/**
 * A trial pass that reads its view: red is the distance along the view's axis in units of 16 m, green the previous red,
 * blue the previous green. So a pixel shows the distances of up to three nested views.
 */
final class DistancePass implements Pass {
    private static final TargetReads READS = TargetReads.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR);

    private final FullScreenDrawing drawing;
    private final Map<Target, Texture> targets;

    private DistancePass(LoadContext context) {
        targets = context.targets();
        String folder = "/nephele/engine/render/trial/";
        drawing = new FullScreenDrawing(context, Defines.of(context), folder + "trial.vert", folder + "distance.frag");
    }

    static RenderFeature of(Stage stage) {
        return new RenderFeature("distance", stage, request -> List.of(new Required("trial", DistancePass::new)));
    }

    @Override
    public Set<Target> reads() {
        return READS.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        READS.bind(targets);
        drawing.draw(frame.surface(), Depth.OFF);
    }
}
