package nephele.engine.render.frame;

import java.util.function.Consumer;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** Runs one shader over a whole target. */
public final class FullScreenDrawing {
    private final GlContext gl;
    private final FullScreenTriangle triangle;
    private final GlProgram<?> program;

    /** The file names of a program's two shaders. */
    public record Stages(String vertex, String fragment) {}

    /**
     * Compiles for the output of {@code context}.
     *
     * @param folder the folder of both resources, ending in a slash
     * @param tie binds the program's samplers and blocks permanently
     */
    public FullScreenDrawing(LoadContext context, String folder, Stages stages, Consumer<Uniforms> tie) {
        this(context, Defines.of(context), folder, stages, tie);
    }

    /** Compiles with other defines. */
    public FullScreenDrawing(
            LoadContext context, Defines choices, String folder, Stages stages, Consumer<Uniforms> tie) {
        gl = context.gl();
        triangle = context.own(new FullScreenTriangle(gl, stages.fragment()));
        var defines = choices.values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(folder + stages.vertex(), defines),
                ShaderSource.load(folder + stages.fragment(), defines),
                uniforms -> {
                    tie.accept(uniforms);
                    return uniforms;
                });
    }

    /** Replaces the content of the target; the caller has bound the textures. */
    public void draw(RenderTarget target, Depth depth) {
        target.bind();
        gl.state().set(depth, Blend.REPLACE, Cull.NONE);
        program.use();
        triangle.draw();
    }
}
