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
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.SkyVisibility;

/** Publishes the baked light map of the static faces to the surfaces. */
public final class SkyVisibilityPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("sky-visibility", Stage.ONCE_A_FRAME, SkyVisibilityPass::requiredBy);

    private SkyVisibilityPass(LoadContext context) {
        SkyVisibility visibility = context.scene().light().visibility();
        Texture map = context.share(
                Texture.class, new Identity(visibility.texels()), () -> texture(context.gl(), visibility));
        context.targets().put(Target.SKY_VISIBILITY, map);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.SKY_VISIBILITY)
                ? List.of(new Required(
                        "environment.sky: its light falls on " + LightRequirements.surfaces(request.level()),
                        SkyVisibilityPass::new))
                : List.of();
    }

    private static Texture texture(GlContext gl, SkyVisibility visibility) {
        Texture.Extent extent = Texture.Extent.flat(
                visibility.layout().width(), visibility.layout().height());
        Texture map =
                new Texture(gl, "sky visibility", Texture.Shape.FLAT, PixelFormat.R16, extent, Sampling.LINEAR_CLAMP);
        ByteBuffer texels =
                ByteBuffer.allocateDirect(2 * visibility.texels().length).order(ByteOrder.nativeOrder());
        texels.asShortBuffer().put(visibility.texels());
        map.upload(0, texels);
        return map;
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SKY_VISIBILITY);
    }

    /** Nothing changes: the published texture stays. */
    @Override
    public void draw(FrameContext frame) {}
}
