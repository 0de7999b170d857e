package nephele.engine.render.pass.thing;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.scene.thing.HeldSight;
import nephele.engine.scene.thing.VisibleThings;

/** What moves: one call for each run of things that look alike and are seen. */
public final class ThingPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("thing", ThingPass::requiredBy);

    private final TargetReads reads;
    private ThingMeshes meshes;
    private VisibleThings visible;
    private HeldSight held;
    private ThingDraw draw;

    private ThingPass(TargetReads reads) {
        this.reads = reads;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (!request.hasBodies() && !request.mayShowFigure()) {
            return List.of();
        }
        String because = request.hasBodies() ? "bodies: things that move" : "player: a figure to be seen";
        return List.of(
                new Required(because, gl -> new ThingPass(request.lightMaps().things())));
    }

    @Override
    public Stage stage() {
        return Stage.IN_VIEWS;
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public void load(LoadContext context) {
        meshes = context.shared().things(context);
        visible = new VisibleThings(meshes.things(), meshes.copies());
        held = new HeldSight(meshes.copies());
        draw = new ThingDraw(context, ThingLook.SOLID, reads);
    }

    @Override
    public void draw(FrameContext frame) {
        meshes.update(frame.moment());
        held.find(frame.view(), frame.moment());
        see(frame);
        if (visible.runs() > 0) {
            draw.draw(frame, visible);
        }
    }

    private void see(FrameContext frame) {
        if (frame.limits() != null) {
            visible.find(frame.view(), frame.limits(), frame.surface().height(), held);
        } else {
            visible.find(frame.view(), frame.surface().height(), held);
        }
    }

    @Override
    public void close() {
        if (draw != null) {
            draw.close();
        }
    }
}
