package nephele.engine.render.pass.shadow;

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
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.dynamic.ContactCasters;

/** Chooses the moving objects near which the surfaces of a frame's views have less ambient light; draws nothing itself. */
public final class ContactPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "shadow.contact", Stage.ONCE_A_FRAME, ContactPass::requiredBy)
            .using(DynamicMeshes.RESOURCE, SurfaceLight.RESOURCE);

    private final DynamicMeshes meshes;
    private final SurfaceLight light;
    private final ContactCasters casters;

    private ContactPass(LoadContext context) {
        meshes = context.get(DynamicMeshes.RESOURCE);
        light = context.get(SurfaceLight.RESOURCE);
        casters = new ContactCasters(meshes.dynamicObjects(), meshes.copies(), light.anchor(), light.contactSpheres());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (!request.drawsContact()) {
            return List.of();
        }
        String because = request.hasBodies() ? "bodies in baked light" : "player: a character in baked light";
        return List.of(new Required(because, ContactPass::new));
    }

    @Override
    public Set<Target> writes() {
        return Set.of();
    }

    @Override
    public void draw(FrameContext frame) {
        meshes.update(frame.frameState());
        light.contact(casters.choose(frame.view(), frame.frustum(), frame.node()));
    }
}
