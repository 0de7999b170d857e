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

/**
 * What the player holds before the own eyes: see-through, over all else that the view shows. Bodies are convex, so one
 * layer of front faces covers each pixel and no order matters. Its shadow and every other sight of it stay solid.
 */
public final class HeldPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("thing.held", HeldPass::requiredBy);

    /** So much of what is behind is hidden by the middle of a face: a define of {@code held-look.glsl}. */
    public static final double FACE_OPACITY = 0.3;

    private final TargetReads reads;
    private ThingMeshes meshes;
    private VisibleThings visible;
    private HeldSight held;
    private ThingDraw draw;

    private HeldPass(TargetReads reads) {
        this.reads = reads;
    }

    /** A player's hands, where there is something for them to hold. */
    private static List<Required> requiredBy(FrameRequest request) {
        return request.mayShowFigure() && request.hasBodies()
                ? List.of(new Required(
                        "player: a body that is held",
                        gl -> new HeldPass(request.lightMaps().things())))
                : List.of();
    }

    @Override
    public Stage stage() {
        return Stage.IN_VIEWS_AFTER_OPAQUE;
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
        draw = new ThingDraw(context, ThingLook.SEE_THROUGH, reads);
    }

    @Override
    public void draw(FrameContext frame) {
        held.find(frame.view(), frame.moment());
        if (held.size() > 0) {
            visible.take(held);
            draw.draw(frame, visible);
        }
    }

    @Override
    public void close() {
        if (draw != null) {
            draw.close();
        }
    }
}
