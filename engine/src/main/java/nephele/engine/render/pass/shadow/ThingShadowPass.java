package nephele.engine.render.pass.shadow;

import java.util.EnumSet;
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
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.frame.ThingShade;

/** Depth maps of what moves, for the sun and for lamps; drawn again when something has moved or the eye has gone far. */
public final class ThingShadowPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("shadow.things", Stage.ONCE_A_FRAME, ThingShadowPass::requiredBy);

    private final Set<Target> writes;
    private final ThingMeshes meshes;
    private final ThingDepthDraw depth;
    private final ThingShade shade;
    /** {@code null} where no sun casts; {@link #lamps} likewise. */
    private final ThingSunShadow sun;

    private final ThingLampShadow lamps;
    private long drawn = -1;

    private ThingShadowPass(LoadContext context, Set<Target> writes) {
        this.writes = writes;
        meshes = context.shared().things();
        depth = new ThingDepthDraw(context, meshes);
        shade = context.shared().surfaceLight().thingShade();
        sun = shade.sun() ? new ThingSunShadow(context, meshes) : null;
        lamps = shade.lamps() ? new ThingLampShadow(context, meshes, depth) : null;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Set<Target> targets = EnumSet.of(Target.THING_SUN_SHADOW, Target.THING_LAMP_SHADOW);
        targets.removeIf(target -> !request.lightMaps().has(target));
        if (targets.isEmpty()) {
            return List.of();
        }
        String because =
                request.hasBodies() ? "bodies: things that shade others" : "player: a figure that casts a shadow";
        return List.of(new Required(because, context -> new ThingShadowPass(context, targets)));
    }

    @Override
    public Set<Target> writes() {
        return writes;
    }

    @Override
    public void draw(FrameContext frame) {
        long now = meshes.update(frame.moment());
        boolean haveMoved = now != drawn;
        drawn = now;
        if (lamps != null) {
            lamps.follow(now);
        }
        boolean isSunDrawn = sun != null && sun.follow(depth, frame, haveMoved);
        if (haveMoved || isSunDrawn) {
            shade.upload();
        }
    }
}
