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
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.ShadowFrame;

/** The sun's depth map over all solids that can shade another. */
public final class SunShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("shadow.sun", SunShadowPass::requiredBy);

    private final GlContext gl;
    private Texture map;

    private SunShadowPass(GlContext gl) {
        this.gl = gl;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.SUN_SHADOW)
                ? List.of(new Required(
                        "environment.sun.castsShadow: " + LightNeeds.surfaces(request.level()) + " that shade others",
                        SunShadowPass::new))
                : List.of();
    }

    @Override
    public Stage stage() {
        return Stage.ONCE_A_FRAME;
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SUN_SHADOW);
    }

    @Override
    public void load(LoadContext context) {
        ShadowFrame frame = context.shared().surfaceLight(context).sunFrame();
        Texture.Extent extent = new Texture.Extent(frame.width(), frame.height(), 1);
        map = new Texture(gl, "sun shadow", Texture.Shape.ARRAY, PixelFormat.DEPTH32F, extent, Sampling.NEAREST_CLAMP);
        try (DepthDraw depth = new DepthDraw(context);
                RenderTarget target = RenderTarget.depthLayer(gl, "sun shadow", map, 0)) {
            depth.draw(target, frame.clipFromAnchor(), frame.anchor(), DepthDraw.PARALLEL);
        }
        context.shared().publish(Target.SUN_SHADOW, map);
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
