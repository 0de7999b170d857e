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
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.frame.ThingShade;

/** Depth maps of what moves, for the sun and for lamps; drawn again when something has moved or the eye has gone far. */
public final class ThingShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("shadow.things", ThingShadowPass::requiredBy);

    private final Set<Target> writes;
    private ThingMeshes meshes;
    private ThingDepthDraw depth;
    private ThingSunShadow sun;
    private ThingLampShadow lamps;
    private ThingShade shade;
    private long drawn = -1;

    private ThingShadowPass(Set<Target> writes) {
        this.writes = writes;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Set<Target> targets = EnumSet.of(Target.THING_SUN_SHADOW, Target.THING_LAMP_SHADOW);
        targets.removeIf(target -> !request.lightMaps().has(target));
        if (targets.isEmpty()) {
            return List.of();
        }
        String because =
                request.hasBodies() ? "bodies: things that shade others" : "player: a figure that casts a shadow";
        return List.of(new Required(because, gl -> new ThingShadowPass(targets)));
    }

    @Override
    public Stage stage() {
        return Stage.ONCE_A_FRAME;
    }

    @Override
    public Set<Target> writes() {
        return writes;
    }

    @Override
    public void load(LoadContext context) {
        SurfaceLight light = context.shared().surfaceLight(context);
        shade = light.thingShade();
        meshes = context.shared().things(context);
        depth = new ThingDepthDraw(context, meshes);
        if (shade.sun()) {
            sun = new ThingSunShadow(context, meshes);
        }
        if (shade.lamps()) {
            lamps = new ThingLampShadow(context, meshes);
        }
    }

    @Override
    public void draw(FrameContext frame) {
        long now = meshes.update(frame.moment());
        if (now == drawn && (sun == null || !sun.isOutgrown(frame.view().eye()))) {
            return;
        }
        drawn = now;
        if (sun != null) {
            sun.draw(depth, frame.view().eye());
        }
        if (lamps != null) {
            lamps.draw(depth);
        }
        shade.upload();
    }

    @Override
    public void close() {
        if (depth != null) {
            depth.close();
        }
        if (sun != null) {
            sun.close();
        }
        if (lamps != null) {
            lamps.close();
        }
    }
}
