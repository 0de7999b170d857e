package nephele.engine.render.pass.shadow;

import java.util.Map;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.DynamicMeshes.RunUniforms;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.dynamic.VisibleInstances;
import org.joml.Matrix4d;

/**
 * Draws the depth of dynamic objects under a projection; both sides of every face, since objects cut at portals are
 * open.
 */
final class DynamicDepthDraw {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    private record DepthUniforms(Matrix4 clipFromAnchor, Scalar depthPerMetre, RunUniforms run) {}

    private final GlContext gl;
    private final DynamicMeshes meshes;
    private final GlProgram<DepthUniforms> program;
    private final int clipDistances;
    private final float[] matrix = new float[16];

    DynamicDepthDraw(LoadContext context, DynamicMeshes meshes) {
        this.gl = context.gl();
        this.meshes = meshes;
        clipDistances = ViewTree.mayGrow(context.scene().level()) ? 3 : 0;
        Map<String, String> defines = Defines.of(context).values();
        program = GlProgram.of(
                gl, FOLDER + "dynamic-depth.vert", FOLDER + "dynamic-depth.frag", defines, DepthUniforms.class);
    }

    /** Draws a sun's picture, whose depth is already linear. */
    void drawParallel(VisibleInstances visible, Matrix4d clipFromAnchor) {
        draw(visible, clipFromAnchor, 0);
    }

    /**
     * Draws into the bound target, whose depth was cleared.
     *
     * @param depthPerMetre 1 / a light's range
     */
    void draw(VisibleInstances visible, Matrix4d clipFromAnchor, double depthPerMetre) {
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE, clipDistances);
        program.use();
        program.uniforms().depthPerMetre().set((float) depthPerMetre);
        program.uniforms().clipFromAnchor().set(clipFromAnchor.get(matrix));
        meshes.bind();
        for (int run = 0; run < visible.runs(); run++) {
            meshes.draw(visible, run, program.uniforms().run());
        }
    }
}
