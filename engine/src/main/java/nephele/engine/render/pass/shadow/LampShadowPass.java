package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LampShadows;
import nephele.engine.scene.light.LightNeeds;

/** The lamps' depth pictures: layers of one texture. */
public final class LampShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("shadow.lamps", LampShadowPass::requiredBy);

    private final GlContext gl;
    private Texture map;

    private LampShadowPass(GlContext gl) {
        this.gl = gl;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.LAMP_SHADOW)
                ? List.of(new Required(because(request.level()), LampShadowPass::new))
                : List.of();
    }

    @Override
    public Stage stage() {
        return Stage.ONCE_A_FRAME;
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.LAMP_SHADOW);
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
    public void load(LoadContext context) {
        SurfaceLight light = context.shared().surfaceLight(context);
        List<Lamp> lamps = light.lamps().lamps();
        LampShadows shadows = light.lamps().shadows();
        Texture.Extent extent = new Texture.Extent(
                shadows.side(), shadows.side(), shadows.layers().size());
        map = new Texture(
                gl, "lamp shadows", Texture.Shape.ARRAY, PixelFormat.DEPTH32F, extent, Sampling.NEAREST_CLAMP);
        try (DepthDraw depth = new DepthDraw(context)) {
            for (int layer = 0; layer < shadows.layers().size(); layer++) {
                try (RenderTarget target = RenderTarget.depthLayer(gl, "lamp shadow " + layer, map, layer)) {
                    Lamp lamp = lamps.get(shadows.layers().get(layer).lamp());
                    depth.draw(
                            target,
                            shadows.clipFromAnchor(lamps, layer, light.anchor()),
                            light.anchor(),
                            LampShadows.depthPerMetre(lamp));
                }
            }
        }
        context.shared().publish(Target.LAMP_SHADOW, map);
    }

    /** Nothing moves: what was drawn while loading stays. */
    @Override
    public void draw(FrameContext frame) {}

    @Override
    public void close() {
        if (map != null) {
            map.close();
        }
    }
}
