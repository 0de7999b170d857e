package nephele.engine.render.pass.solid;

import java.util.Map;
import java.util.Optional;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.frame.SolidMesh;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.ShaderSource;

/** Lays down the depth of all solids, so that costly light is computed once a pixel and not for what is covered. */
final class DepthFirst implements AutoCloseable {
    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    private final GlContext gl;
    private final GlProgram<SolidUniforms> program;
    private final float[] eye = new float[6];

    DepthFirst(GlContext gl) {
        this.gl = gl;
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "depth.vert", Map.of()),
                ShaderSource.load(FOLDER + "depth.frag", Map.of()),
                uniforms -> {
                    uniforms.block("Frame", FrameUniforms.BINDING);
                    return new SolidUniforms(uniforms.vector3("eyeHigh"), uniforms.vector3("eyeLow"), Optional.empty());
                });
    }

    void draw(FrameContext frame, SolidMesh mesh) {
        gl.state().set(Depth.LESS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.BACK);
        program.use();
        for (int i = 0; i < mesh.batches().size(); i++) {
            SolidMesh.eyeInCell(frame.view().eye(), mesh.batches().get(i).cellOrigin(), eye);
            program.uniforms().eye(eye);
            mesh.draw(i, frame.visible());
        }
    }

    @Override
    public void close() {
        program.close();
    }
}
