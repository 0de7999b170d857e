package nephele.engine.render.pass.cloud.volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.View;

/** Draws clouds by marching rays through their cells, the farthest cloud first. */
public final class VolumePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("cloud.volume", Stage.IN_VIEWS_AFTER_OPAQUE, VolumePass::requiredBy);

    private final GlContext gl;
    private final SharedResources shared;
    private final TargetReads reads = TargetReads.of(Target.VIEW_DEPTH);
    private final MarchProgram program;
    private final FullScreenTriangle triangle;
    private final List<MarchedCloud> clouds;

    private VolumePass(LoadContext context) {
        gl = context.gl();
        shared = context.shared();
        program = new MarchProgram(context, Defines.of(context));
        triangle = context.own(new FullScreenTriangle(gl, "volume"));
        Environment environment = context.scene().level().environment();
        clouds = new ArrayList<>();
        for (Cloud cloud : environment.clouds()) {
            MarchedCloud marched = MarchedCloud.of(context, cloud);
            if (!marched.isEmpty()) {
                clouds.add(marched);
            }
        }
    }

    private static List<Required> requiredBy(FrameRequest request) {
        List<Cloud> clouds = request.level().environment().clouds();
        return clouds.isEmpty()
                ? List.of()
                : List.of(new Required(
                        "environment.clouds: " + clouds.size() + " drawn by technique volume", VolumePass::new));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean draws(FrameContext frame) {
        return !clouds.isEmpty();
    }

    @Override
    public void draw(FrameContext frame) {
        if (clouds.isEmpty()) {
            return;
        }
        View view = frame.view();
        clouds.sort((a, b) -> Double.compare(b.distance(view.eye()), a.distance(view.eye())));
        frame.surface().bind();
        gl.state().set(Depth.OFF, Blend.PREMULTIPLIED_OVER, Cull.NONE);
        reads.bind(shared);
        program.use();
        for (int i = 0; i < clouds.size(); i++) {
            clouds.get(i).follow(frame.frameState().environment());
            clouds.get(i).bind(program, view);
            triangle.draw();
        }
    }
}
