package nephele.engine.render.pass.solid;

import java.util.Map;
import java.util.Optional;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.resource.SolidMesh;

/**
 * Writes the depth of all solids first, so that costly light is computed once a pixel and never for hidden surfaces.
 */
final class DepthFirst {
    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    private final GlContext gl;
    private final GlProgram<SolidUniforms> program;
    private final float[] eye = new float[6];

    DepthFirst(LoadContext context) {
        gl = context.gl();
        Map<String, String> defines = Defines.of(context).values();
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "depth.vert", defines),
                ShaderSource.load(FOLDER + "depth.frag", defines),
                uniforms ->
                        new SolidUniforms(uniforms.vector3("eyeHigh"), uniforms.vector3("eyeLow"), Optional.empty()));
    }

    void draw(FrameContext frame, SolidMesh mesh) {
        gl.state().set(Depth.LESS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        program.use();
        for (int i = 0; i < mesh.batches().size(); i++) {
            SolidMesh.eyeInCell(frame.view(), mesh.batches().get(i).cellOrigin(), eye);
            program.uniforms().eye(eye);
            mesh.draw(i, frame.visible());
        }
    }
}
