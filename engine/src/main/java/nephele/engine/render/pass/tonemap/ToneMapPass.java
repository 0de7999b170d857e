package nephele.engine.render.pass.tonemap;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.TextureUnit;

/** Exposure, tone curve, sRGB and dither over the whole picture; exists only for output HDR. */
public final class ToneMapPass implements Pass {
    /** Nothing in a level asks for it yet: blended surfaces and bloom will. */
    public static final RenderFeature FEATURE = new RenderFeature("tonemap", level -> List.of());

    /** What the caller's choice of output HDR requires. */
    public static final Required FOR_OUTPUT_HDR = new Required("output: hdr was asked for", ToneMapPass::new);

    private static final String FOLDER = "/nephele/engine/render/pass/tonemap/";

    private final FullScreenDrawing drawing;

    private ToneMapPass(GlContext gl) {
        drawing = new FullScreenDrawing(gl, "tone map");
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
    public void load(LoadContext context) {
        drawing.load(context, FOLDER, new FullScreenDrawing.Stages("tonemap.vert", "tonemap.frag"), uniforms -> {
            uniforms.sampler("linearPicture", TextureUnit.COLOURS);
            return uniforms;
        });
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().colour().bind(TextureUnit.COLOURS);
        drawing.draw(frame.picture(), Depth.OFF);
    }

    @Override
    public void close() {
        drawing.close();
    }
}
