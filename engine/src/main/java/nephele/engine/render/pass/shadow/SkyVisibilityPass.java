package nephele.engine.render.pass.shadow;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
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
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.SkyVisibility;

/** Hands the baked light map of the static faces to the surfaces. */
public final class SkyVisibilityPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("sky-visibility", SkyVisibilityPass::requiredBy);

    private final GlContext gl;
    private Texture map;

    private SkyVisibilityPass(GlContext gl) {
        this.gl = gl;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.SKY_VISIBILITY)
                ? List.of(new Required(
                        "environment.sky: its light falls on " + LightNeeds.surfaces(request.level()),
                        SkyVisibilityPass::new))
                : List.of();
    }

    @Override
    public Stage stage() {
        return Stage.ONCE_A_FRAME;
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SKY_VISIBILITY);
    }

    @Override
    public void load(LoadContext context) {
        SkyVisibility visibility = context.scene().skyVisibility();
        Texture.Extent extent = Texture.Extent.flat(
                visibility.layout().width(), visibility.layout().height());
        map = new Texture(gl, "sky visibility", Texture.Shape.FLAT, PixelFormat.R16, extent, Sampling.LINEAR_CLAMP);
        ByteBuffer texels =
                ByteBuffer.allocateDirect(2 * visibility.texels().length).order(ByteOrder.nativeOrder());
        texels.asShortBuffer().put(visibility.texels());
        map.upload(0, texels);
        context.shared().publish(Target.SKY_VISIBILITY, map);
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
