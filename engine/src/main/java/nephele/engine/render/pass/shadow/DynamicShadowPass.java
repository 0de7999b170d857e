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
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.DynamicShadows;
import nephele.engine.render.resource.SurfaceLight;

/**
 * Draws depth maps of dynamic objects for the sun and punctual lights, again when an object has moved or the eye has
 * moved far.
 */
public final class DynamicShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "shadow.dynamic", Stage.ONCE_A_FRAME, DynamicShadowPass::requiredBy)
            .using(DynamicMeshes.RESOURCE, SurfaceLight.RESOURCE);

    private final Set<Target> writes;
    private final DynamicMeshes meshes;
    private final DynamicDepthDraw depth;
    private final DynamicShadows shade;
    /** {@code null} without a sun that casts shadows; {@link #lights} likewise. */
    private final DynamicSunShadow sun;

    private final DynamicLightShadow lights;
    private long drawn = -1;

    private DynamicShadowPass(LoadContext context, Set<Target> writes) {
        this.writes = writes;
        meshes = context.get(DynamicMeshes.RESOURCE);
        depth = new DynamicDepthDraw(context, meshes);
        shade = context.get(SurfaceLight.RESOURCE).dynamicShadows();
        sun = shade.sun() ? new DynamicSunShadow(context, meshes) : null;
        lights = shade.lights() ? new DynamicLightShadow(context, meshes, depth) : null;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Set<Target> targets = EnumSet.of(Target.DYNAMIC_SUN_SHADOW, Target.DYNAMIC_LIGHT_SHADOW);
        targets.removeIf(target -> !request.lightMaps().has(target));
        if (targets.isEmpty()) {
            return List.of();
        }
        String because = request.hasBodies()
                ? "bodies: dynamic objects that cast shadows"
                : "player: a character that casts a shadow";
        return List.of(new Required(because, context -> new DynamicShadowPass(context, targets)));
    }

    @Override
    public Set<Target> writes() {
        return writes;
    }

    @Override
    public void draw(FrameContext frame) {
        long now = meshes.update(frame.frameState());
        boolean haveMoved = now != drawn;
        drawn = now;
        if (lights != null) {
            lights.follow(now);
        }
        boolean isSunDrawn = sun != null && sun.follow(depth, frame, haveMoved);
        if (haveMoved || isSunDrawn) {
            shade.upload();
        }
    }
}
