package nephele.engine.render.pass.dynamic;

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
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.dynamic.HeldBodyVisibility;
import nephele.engine.scene.dynamic.VisibleInstances;

/**
 * Draws dynamic objects: one call for each run of visible objects of one group. In the player's own first-person view,
 * the held body has a separate pass, because it is transparent and drawn over the rest of the view. Bodies are convex,
 * so one layer of front faces covers each pixel and no sorting is needed. The body's shadow and its other images stay
 * solid.
 */
public final class DynamicPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("dynamic", Stage.IN_VIEWS, DynamicPass::requiredBy)
            .using(DynamicMeshes.RESOURCE, PictureArrays.COLOURS, PictureArrays.NORMALS, SurfaceLight.RESOURCE);
    public static final RenderFeature HELD = new RenderFeature(
                    "dynamic.held", Stage.IN_VIEWS_AFTER_OPAQUE, DynamicPass::heldRequiredBy)
            .using(DynamicMeshes.RESOURCE, PictureArrays.COLOURS, PictureArrays.NORMALS, SurfaceLight.RESOURCE);

    /** The opacity of the middle of a held face; a define of {@code held-look.glsl}. */
    public static final double HELD_FACE_OPACITY = 0.3;

    private final DynamicBlending look;
    private final TargetReads reads;
    private final DynamicMeshes meshes;
    private final VisibleInstances visible;
    private final HeldBodyVisibility held;
    private final DynamicDraw draw;

    private DynamicPass(LoadContext context, DynamicBlending look, TargetReads reads) {
        this.look = look;
        this.reads = reads;
        meshes = context.get(DynamicMeshes.RESOURCE);
        visible = new VisibleInstances(meshes.dynamicObjects(), meshes.copies());
        held = new HeldBodyVisibility(meshes.copies());
        draw = new DynamicDraw(context, look, reads);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (!request.hasBodies() && !request.mayShowCharacter()) {
            return List.of();
        }
        String because = request.hasBodies() ? "bodies: dynamic objects" : "player: a visible character";
        return required(because, DynamicBlending.SOLID, request);
    }

    /** Requires the pass for held bodies in a level with bodies and a player. */
    private static List<Required> heldRequiredBy(FrameRequest request) {
        return request.mayShowCharacter() && request.hasBodies()
                ? required("player: a body that is held", DynamicBlending.SEE_THROUGH, request)
                : List.of();
    }

    private static List<Required> required(String because, DynamicBlending look, FrameRequest request) {
        TargetReads reads = request.lightMaps().dynamicObjects();
        return List.of(new Required(because, context -> new DynamicPass(context, look, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        if (look == DynamicBlending.SOLID) {
            meshes.update(frame.frameState());
        }
        held.find(frame.view(), frame.frameState());
        bindView(frame);
        if (visible.runs() > 0) {
            draw.draw(frame, visible);
        }
    }

    private void bindView(FrameContext frame) {
        if (look == DynamicBlending.SEE_THROUGH) {
            visible.selectHeld(held);
        } else if (frame.limits() != null) {
            visible.find(frame.view(), frame.limits(), frame.surface().height(), held);
        } else {
            visible.find(frame.view(), frame.surface().height(), held);
        }
    }
}
