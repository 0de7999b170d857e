package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LampShadows;
import nephele.engine.scene.light.LampTable;
import nephele.engine.scene.light.LightNeeds;

/** The lamps' depth pictures: layers of one texture, drawn again when their lamp, or a solid near it, is another. */
public final class LampShadowPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("shadow.lamps", Stage.ONCE_A_FRAME, LampShadowPass::requiredBy);

    private final SharedResources shared;
    private final List<Lamp> lamps;
    private final LampShadows shadows;
    private final Vec3 anchor;
    private final DepthDraw depth;
    private final DepthLayers maps;
    private final List<Content> contents;
    private final Texture.Extent extent;

    /** What a picture follows from. */
    private record Content(Lamp lamp, int axis, Same shade, Vec3 anchor) {}

    private LampShadowPass(LoadContext context) {
        shared = context.shared();
        LampTable table = shared.surfaceLight().lamps();
        lamps = table.lamps();
        shadows = table.shadows();
        anchor = shared.surfaceLight().anchor();
        depth = new DepthDraw(context);
        maps = DepthDraw.layers(context, "lamp shadows");
        contents = shadows.layers().stream()
                .map(layer ->
                        new Content(lamps.get(layer.lamp()), layer.axis(), new Same(table.shade(layer.lamp())), anchor))
                .toList();
        extent = new Texture.Extent(
                shadows.side(), shadows.side(), shadows.layers().size());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.LAMP_SHADOW)
                ? List.of(new Required(because(request.level()), LampShadowPass::new))
                : List.of();
    }

    private static String because(Level level) {
        for (int i = 0; i < level.lights().size(); i++) {
            if (LightNeeds.casts(level.lights().get(i))) {
                return "lights[" + i + "].castsShadow: " + LightNeeds.surfaces(level) + " that shade others";
            }
        }
        throw new IllegalArgumentException("no lamp casts");
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.LAMP_SHADOW);
    }

    @Override
    public void draw(FrameContext frame) {
        shared.publish(Target.LAMP_SHADOW, maps.showing(contents, extent, this::draw));
    }

    private void draw(int layer, RenderTarget target) {
        Lamp lamp = lamps.get(shadows.layers().get(layer).lamp());
        depth.drawInFrustum(
                target, shadows.clipFromAnchor(lamps, layer, anchor), anchor, LampShadows.depthPerMetre(lamp));
    }
}
