package nephele.engine.render.pass.upscale;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.shader.TextureUnit;

/**
 * Scales the picture up; exists only if quality draws fewer pixels than the final picture has, and does not average frames,
 * which scales too.
 */
public final class UpscalePass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("upscale", Stage.AFTER_ALL, UpscalePass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/upscale/";

    /**
     * The slope of the weights of {@code SHARP_BILINEAR}; 1 is bilinear. Greater ones are nearer to the whole picture, and
     * shimmer more (docs/decisions/performance.md).
     */
    public static final double STEEPNESS = 1.5;

    private final FullScreenDrawing drawing;

    private UpscalePass(LoadContext context) {
        Defines defines = new Defines().with(context.quality().upscale().name()).with("STEEPNESS", STEEPNESS);
        drawing = new FullScreenDrawing(context, defines, FOLDER + "upscale.vert", FOLDER + "upscale.frag");
    }

    private static List<Required> requiredBy(FrameRequest request) {
        double resolution = request.quality().pictureResolution();
        return resolution == 1 || request.isAccumulated() || !request.drawsSomething()
                ? List.of()
                : List.of(new Required("quality: pictureResolution " + resolution, UpscalePass::new));
    }

    @Override
    public Set<Target> reads() {
        return Set.of(Target.SURFACE);
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
