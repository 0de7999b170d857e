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
import nephele.engine.render.resource.SummedLight;
import nephele.engine.scene.light.LightRequirements;

/** Publishes the light that was baked for the static faces. */
public final class BakedLightPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "baked-light", Stage.ONCE_A_FRAME, BakedLightPass::requiredBy)
            .using(SummedLight.RESOURCE);

    private BakedLightPass(LoadContext context) {
        context.targets()
                .put(Target.BAKED_LIGHT, context.get(SummedLight.RESOURCE).texture());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.BAKED_LIGHT)
                ? List.of(new Required(
                        "bake: light was baked for " + LightRequirements.surfaces(request.level()),
                        BakedLightPass::new))
                : List.of();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.BAKED_LIGHT);
    }

    /** Nothing is drawn: {@link SummedLight} follows the gains of the layers. */
    @Override
    public void draw(FrameContext frame) {}
}
