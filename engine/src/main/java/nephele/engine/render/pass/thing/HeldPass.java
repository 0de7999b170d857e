package nephele.engine.render.pass.thing;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.scene.thing.HeldSight;
import nephele.engine.scene.thing.VisibleThings;

/**
 * What the player holds before the own eyes: see-through, over all else that the view shows. Bodies are convex, so one
 * layer of front faces covers each pixel and no order matters. Its shadow and every other sight of it stay solid.
 */
public final class HeldPass implements Pass {
    /** No level asks for it: whoever plays does, see {@link #forHands}. */
    public static final RenderFeature FEATURE = new RenderFeature("thing.held", level -> List.of());

    /** So much of what is behind is hidden by the middle of a face: a define of {@code held-look.glsl}. */
    public static final double FACE_OPACITY = 0.3;

    private final Set<Target> reads;
    private ThingMeshes meshes;
    private VisibleThings visible;
    private HeldSight held;
    private ThingDraw draw;

    private HeldPass(Set<Target> reads) {
        this.reads = reads;
    }

    /** What whoever plays asks for where there is something to be held. */
    public static List<Required> forHands(Level level) {
        Set<Target> reads = SurfaceLight.targetsRead(level);
        return level.bodies().isEmpty()
                ? List.of()
                : List.of(new Required("player: a body that is held", gl -> new HeldPass(reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads;
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
        draw = new ThingDraw(context, ThingLook.SEE_THROUGH);
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
