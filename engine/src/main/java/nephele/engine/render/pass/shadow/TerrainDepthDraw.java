package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.render.resource.TerrainUniforms;
import org.joml.Matrix4d;

/** Draws the depth of all terrains under a projection. */
final class TerrainDepthDraw {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    private record DepthUniforms(TerrainUniforms place, Matrix4 clipFromOrigin, Scalar depthPerMetre) {}

    private final List<TerrainMesh> meshes;
    /** {@code null} without terrains. */
    private final GlProgram<DepthUniforms> program;

    TerrainDepthDraw(LoadContext context) {
        meshes = context.get(TerrainMesh.RESOURCE);
        program = meshes.isEmpty()
                ? null
                : GlProgram.of(
                        context.gl(),
                        FOLDER + "terrain-depth.vert",
                        FOLDER + "terrain-depth.frag",
                        Map.of(),
                        DepthUniforms.class);
    }

    /** Draws the parts in a frustum; the state is that of {@link DepthDraw}. */
    void draw(Frustum seen, Matrix4d clipFromAnchor, Vec3 anchor, double depthPerMetre) {
        for (TerrainMesh mesh : meshes) {
            HeightField field = mesh.field();
            Vec3 origin = field.origin();
            program.use();
            DepthUniforms uniforms = program.uniforms();
            uniforms.depthPerMetre().set((float) depthPerMetre);
            Matrix4d clipFromOrigin = clipFromAnchor.translate(
                    origin.x() - anchor.x(), origin.y() - anchor.y(), origin.z() - anchor.z(), new Matrix4d());
            uniforms.clipFromOrigin().set(clipFromOrigin.get(new float[16]));
            uniforms.place().set(field, origin.x(), origin.y(), origin.z());
            mesh.bind();
            mesh.draw(seen, (column, row) -> uniforms.place().chunk(field, column, row));
        }
    }
}
