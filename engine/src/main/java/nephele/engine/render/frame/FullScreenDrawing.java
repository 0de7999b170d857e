package nephele.engine.render.frame;

import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.Uniforms;

/** Runs one shader over a whole target. */
public final class FullScreenDrawing {
    private final GlContext gl;
    private final FullScreenTriangle triangle;
    private final GlProgram<Uniforms> program;

    /**
     * Compiles two shaders.
     *
     * @param vertex path of the resource; {@code fragment} likewise
     */
    public FullScreenDrawing(LoadContext context, Defines defines, String vertex, String fragment) {
        gl = context.gl();
        triangle = context.own(new FullScreenTriangle(gl, fragment));
        program = GlProgram.of(gl, vertex, fragment, defines.values());
    }

    /** Returns the program's uniforms. */
    public <R extends Record> R uniforms(Class<R> type) {
        return program.uniforms().record(type);
    }

    /** Replaces the content of the target; the caller has bound the textures. */
    public void draw(RenderTarget target, Depth depth) {
        target.bind();
        gl.state().set(depth, Blend.REPLACE, Cull.NONE);
        program.use();
        triangle.draw();
    }
}
