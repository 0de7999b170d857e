package nephele.engine.render.pass.shadow;

import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SolidMesh;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms.Matrix4;
import nephele.engine.render.gl.Uniforms.Scalar;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.VisibleSet;
import org.joml.Matrix4d;

/** Draws the depth of all solids under a projection; both sides of every face, so that no crack stays open. */
final class DepthDraw implements AutoCloseable {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    /** Of a sun's picture: its depth is linear as it is. */
    static final double PARALLEL = 0;

    private record DepthUniforms(Matrix4 clipFromCell, Scalar depthPerMetre) {}

    private final LoadContext context;
    private final GlProgram<DepthUniforms> program;
    private final VisibleSet everything;

    DepthDraw(LoadContext context) {
        this.context = context;
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "depth.vert", Map.of()),
                ShaderSource.load(FOLDER + "depth.frag", Map.of()),
                uniforms -> new DepthUniforms(uniforms.matrix4("clipFromCell"), uniforms.scalar("depthPerMetre")));
        everything = new VisibleSet(context.scene().solids());
        everything.takeAll();
    }

    /**
     * @param clipFromAnchor clip space from metres relative to {@code anchor}
     * @param depthPerMetre 1 / a lamp's range, or {@link #PARALLEL}
     */
    void draw(RenderTarget target, Matrix4d clipFromAnchor, Vec3 anchor, double depthPerMetre) {
        target.clearDepth();
        context.gl().state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        program.use();
        program.uniforms().depthPerMetre().set((float) depthPerMetre);
        SolidMesh mesh = context.shared().solids();
        for (int i = 0; i < mesh.batches().size(); i++) {
            SolidBatch batch = mesh.batches().get(i);
            Vec3 cell = batch.cellOrigin();
            Matrix4d clipFromCell = clipFromAnchor.translate(
                    cell.x() - anchor.x(), cell.y() - anchor.y(), cell.z() - anchor.z(), new Matrix4d());
            program.uniforms().clipFromCell().set(clipFromCell.get(new float[16]));
            mesh.draw(i, everything);
        }
    }

    @Override
    public void close() {
        program.close();
    }
}
