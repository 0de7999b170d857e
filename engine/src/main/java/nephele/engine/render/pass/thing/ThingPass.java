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

/** What moves: one call for each run of things that look alike and are seen. */
public final class ThingPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("thing", ThingPass::requiredBy);

    private final Set<Target> reads;
    private ThingMeshes meshes;
    private VisibleThings visible;
    private HeldSight held;
    private ThingDraw draw;

    private ThingPass(Set<Target> reads) {
        this.reads = reads;
    }

    private static List<Required> requiredBy(Level level) {
        return level.bodies().isEmpty() ? List.of() : List.of(required(level, "bodies: things that move"));
    }

    /** What whoever plays asks for, in a level that asks for nothing itself. */
    public static Required forFigure(Level level) {
        return required(level, "player: a figure to be seen");
    }

    private static Required required(Level level, String because) {
        Set<Target> reads = SurfaceLight.targetsRead(level);
        return new Required(because, gl -> new ThingPass(reads));
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
        draw = new ThingDraw(context, ThingLook.SOLID);
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
