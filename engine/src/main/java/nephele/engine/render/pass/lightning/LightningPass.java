package nephele.engine.render.pass.lightning;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.MeteredExposure;

/**
 * Adds the bolt of a strike to each view: behind surfaces it is hidden, and clouds in front of a point take from it what
 * the pass of clouds has found. Between strikes it draws nothing.
 */
public final class LightningPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "lightning", Stage.IN_VIEWS_AFTER_OPAQUE, LightningPass::requiredBy)
            .using(FrameLightning.RESOURCE, MeteredExposure.RESOURCE);

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final FrameLightning lightning;
    private final TargetReads reads;
    private final BoltProgram program;

    private LightningPass(LoadContext context) {
        gl = context.gl();
        targets = context.targets();
        lightning = context.get(FrameLightning.RESOURCE);
        boolean hasClouds = hasClouds(context.request());
        reads = hasClouds ? TargetReads.of(Target.BOLT_TRANSMITTANCE) : TargetReads.of();
        program = new BoltProgram(context, hasClouds);
    }

    private static boolean hasClouds(FrameRequest request) {
        return !WeatherClouds.all(request.level().environment()).isEmpty();
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.level().environment().hasLightning()
                ? List.of(new Required(
                        "environment.lightning: "
                                + request.level().environment().lightning().strikesPerMinute()
                                + " strikes a minute",
                        LightningPass::new))
                : List.of();
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        if (!lightning.isLit()) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.ADD, Cull.NONE, frame.clipDistances());
        reads.bind(targets);
        program.draw(frame, lightning);
    }
}
