package nephele.engine.render.frame;

import java.util.function.Function;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms;

/** One shader over a whole target. */
public final class FullScreenDrawing implements AutoCloseable {
    private final GlContext gl;
    private final FullScreenTriangle triangle;
    private GlProgram<Object> program;

    public FullScreenDrawing(GlContext gl, String name) {
        this.gl = gl;
        triangle = new FullScreenTriangle(gl, name);
    }

    /**
     * Compiles for the output of {@code context}; the frame's block is bound already when {@code set} is called.
     *
     * @param folder of both resources, ending in a slash
     */
    public void load(LoadContext context, String folder, Stages stages, Function<Uniforms, Object> set) {
        var defines = Defines.of(context).values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(folder + stages.vertex(), defines),
                ShaderSource.load(folder + stages.fragment(), defines),
                uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    return set.apply(uniforms);
                });
    }

    /** File names of a program's two shaders. */
    public record Stages(String vertex, String fragment) {}

    /** Replaces what is there; textures have been bound by the caller. */
    public void draw(RenderTarget target, Depth depth) {
        target.bind();
        gl.state().set(depth, Blend.REPLACE, Cull.NONE);
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
