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
 * What moves: one call for each run of things that look alike and are seen. What the player holds before the own eyes
 * has a pass of its own, because it is see-through, over all else that the view shows. Bodies are convex, so one layer of
 * front faces covers each pixel and no order matters. Its shadow and every other sight of it stay solid.
 */
public final class ThingPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("thing", Stage.IN_VIEWS, ThingPass::requiredBy);
    public static final RenderFeature HELD =
            new RenderFeature("thing.held", Stage.IN_VIEWS_AFTER_OPAQUE, ThingPass::heldRequiredBy);

    /** The share of what is behind that the middle of a held face hides: a define of {@code held-look.glsl}. */
    public static final double HELD_FACE_OPACITY = 0.3;

    private final ThingLook look;
    private final TargetReads reads;
    private final ThingMeshes meshes;
    private final VisibleThings visible;
    private final HeldSight held;
    private final ThingDraw draw;

    private ThingPass(LoadContext context, ThingLook look, TargetReads reads) {
        this.look = look;
        this.reads = reads;
        meshes = context.shared().things();
        visible = new VisibleThings(meshes.things(), meshes.copies());
        held = new HeldSight(meshes.copies());
        draw = new ThingDraw(context, look, reads);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (!request.hasBodies() && !request.mayShowFigure()) {
            return List.of();
        }
        String because = request.hasBodies() ? "bodies: things that move" : "player: a figure to be seen";
        return required(because, ThingLook.SOLID, request);
    }

    /** A player's hands, where there is something for them to hold. */
    private static List<Required> heldRequiredBy(FrameRequest request) {
        return request.mayShowFigure() && request.hasBodies()
                ? required("player: a body that is held", ThingLook.SEE_THROUGH, request)
                : List.of();
    }

    private static List<Required> required(String because, ThingLook look, FrameRequest request) {
        TargetReads reads = request.lightMaps().things();
        return List.of(new Required(because, context -> new ThingPass(context, look, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        if (look == ThingLook.SOLID) {
            meshes.update(frame.moment());
        }
        held.find(frame.view(), frame.moment());
        see(frame);
        if (visible.runs() > 0) {
            draw.draw(frame, visible);
        }
    }

    private void see(FrameContext frame) {
        if (look == ThingLook.SEE_THROUGH) {
            visible.take(held);
        } else if (frame.limits() != null) {
            visible.find(frame.view(), frame.limits(), frame.surface().height(), held);
        } else {
            visible.find(frame.view(), frame.surface().height(), held);
        }
    }
}
