package nephele.engine.render.pass.tonemap;

import java.util.List;
import java.util.Set;
import nephele.engine.level.appearance.LinearLight;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.shader.TextureUnit;

/** Exposure, tone curve, sRGB and dither over the whole picture; exists only for output HDR. */
public final class ToneMapPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("tonemap", Stage.AFTER_ALL, ToneMapPass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/tonemap/";

    private final FullScreenDrawing drawing;
    private final boolean isMetered;

    private ToneMapPass(LoadContext context) {
        isMetered = context.request().metersExposure();
        drawing = new FullScreenDrawing(context, Defines.of(context), FOLDER + "tonemap.vert", FOLDER + "tonemap.frag");
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (request.output() != Output.HDR) {
            return List.of();
        }
        String because = LinearLight.because(request.level()).orElse("output: hdr was asked for");
        return List.of(new Required(because, ToneMapPass::new));
    }

    @Override
    public Set<Target> reads() {
        return isMetered ? Set.of(Target.SURFACE, Target.EXPOSURE) : Set.of(Target.SURFACE);
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.PICTURE);
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().colour().bind(TextureUnit.COLOURS);
        drawing.draw(frame.picture(), Depth.OFF);
    }
}
