package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Set;
import nephele.engine.level.planted.PlantedModels;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.ShadowFrame;

/**
 * Draws the sun's depth map of all solids that can cast a shadow on another, again when the sun or a solid has changed.
 */
public final class SunShadowPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("shadow.sun", Stage.ONCE_A_FRAME, SunShadowPass::requiredBy);

    private final SharedResources shared;
    private final SurfaceLight light;
    private final DepthDraw depth;
    /** {@code null} if no billboard casts a shadow. */
    private final BillboardDepth billboards;

    /** {@code null} without models that are drawn as impostors. */
    private final PlantDepth plants;

    private final DepthLayers map;
    private final Same solids;
    private final Same planted;
    private final Same models;
    private List<Content> contents = List.of();
    private Texture.Extent size;

    /** The data on which a map depends. */
    private record Content(Same solids, Same planted, Same models, ShadowFrame frame) {}

    private SunShadowPass(LoadContext context) {
        shared = context.shared();
        light = shared.surfaceLight();
        depth = new DepthDraw(context);
        boolean isPlanted = LightRequirements.billboardsCast(context.scene().level());
        billboards = isPlanted ? new BillboardDepth(context) : null;
        map = DepthDraw.layers(context, "sun shadow");
        solids = new Same(context.scene().solids());
        planted = new Same(isPlanted ? context.scene().level().billboards() : List.of());
        boolean hasPlants = PlantedModels.isIn(context.scene().level());
        plants = hasPlants ? new PlantDepth(context) : null;
        models = new Same(hasPlants ? context.scene().statics() : List.of());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.SUN_SHADOW)
                ? List.of(new Required(
                        "environment.sun.castsShadow: " + LightRequirements.surfaces(request.level())
                                + " that shade others",
                        SunShadowPass::new))
                : List.of();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SUN_SHADOW);
    }

    @Override
    public void draw(FrameContext context) {
        ShadowFrame frame = light.sunFrame();
        if (contents.isEmpty() || contents.get(0).frame != frame) {
            contents = List.of(new Content(solids, planted, models, frame));
            size = new Texture.Extent(frame.width(), frame.height(), 1);
        }
        Texture texture = map.showing(contents, size, (layer, target) -> draw(target, frame));
        shared.publish(Target.SUN_SHADOW, texture);
    }

    private void draw(RenderTarget target, ShadowFrame frame) {
        depth.drawAll(target, frame.clipFromAnchor(), frame.anchor());
        if (billboards != null) {
            billboards.draw(frame, light.towardsSun());
        }
        if (plants != null) {
            plants.draw(frame, light.towardsSun());
        }
    }
}
