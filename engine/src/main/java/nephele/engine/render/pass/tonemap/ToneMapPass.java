package nephele.engine.render.pass.tonemap;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.ShaderSource;

/** Exposure, tone curve, sRGB and dither over the whole picture; exists only for output HDR. */
public final class ToneMapPass implements Pass {
    /** Nothing in a level asks for it yet: blended surfaces and bloom will. */
    public static final RenderFeature FEATURE = new RenderFeature("tonemap", level -> List.of());

    /** What the caller's choice of output HDR requires. */
    public static final Required FOR_OUTPUT_HDR = new Required("output: hdr was asked for", ToneMapPass::new);

    private static final String FOLDER = "/nephele/engine/render/pass/tonemap/";
    private static final int LINEAR_UNIT = 0;

    private final GlContext gl;
    private final FullScreenTriangle triangle;
    private GlProgram<Object> program;

    private ToneMapPass(GlContext gl) {
        this.gl = gl;
        this.triangle = new FullScreenTriangle(gl, "tone map");
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
        var defines = Defines.of(context).values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "tonemap.vert", defines),
                ShaderSource.load(FOLDER + "tonemap.frag", defines),
                uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    uniforms.sampler("linearPicture", LINEAR_UNIT);
                    return uniforms;
                });
    }

    @Override
    public void draw(FrameContext frame) {
        frame.picture().bind();
        frame.surface().colour().bind(LINEAR_UNIT);
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        program.use();
        triangle.draw();
    }

    @Override
    public void close() {
        triangle.close();
        if (program != null) {
            program.close();
        }
    }
}
