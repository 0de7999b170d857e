package nephele.engine.render.line;

import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.LineMesh;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** Many lines of the world that stay on the GPU, a pixel wide, in one colour. */
public final class WorldEdges implements AutoCloseable {
    private final GlContext gl;
    private final Vec3 origin;
    private final LineMesh lines;
    private final GlProgram<Inputs> program;

    private record Inputs(Uniforms.Matrix4 clipFromRelative, Uniforms.Vector3 fromEye, Uniforms.Vector4 colour) {
        static Inputs of(Uniforms uniforms) {
            return new Inputs(
                    uniforms.matrix4("clipFromRelative"),
                    uniforms.vector3("originFromEye"),
                    uniforms.vector4("lineColour"));
        }
    }

    /**
     * Uploads lines.
     *
     * @param origin a point near them
     * @param ends x, y, z of both ends of each line, relative to {@code origin}
     */
    public WorldEdges(GlContext gl, Vec3 origin, float[] ends) {
        this.gl = gl;
        this.origin = origin;
        lines = ends.length == 0 ? null : new LineMesh(gl, "edges", VertexFormat.of(Attribute.FLOAT3), ends);
        program = new GlProgram<>(
                gl,
                ShaderSource.load(LineDrawing.FOLDER + "edges.vert", Map.of()),
                ShaderSource.load(LineDrawing.FOLDER + "edges.frag", Map.of()),
                Inputs::of);
    }

    /** Draws over a picture, whose depth may hide what is behind its surfaces. */
    public void draw(LineProjection projection, LineColour colour, LineLayer layer, RenderTarget picture) {
        if (lines == null) {
            return;
        }
        picture.bind();
        Depth depth = layer == LineLayer.BEHIND_SURFACES ? Depth.LESS_OR_EQUAL : Depth.OFF;
        gl.state().set(depth, Blend.OVER, Cull.NONE);
        program.use();
        Vec3 fromEye = projection.fromEye(origin);
        program.uniforms().clipFromRelative().set(projection.matrix());
        program.uniforms().fromEye().set((float) fromEye.x(), (float) fromEye.y(), (float) fromEye.z());
        program.uniforms().colour().set(colour.red(), colour.green(), colour.blue(), colour.alpha());
        lines.draw();
    }

    @Override
    public void close() {
        if (lines != null) {
            lines.close();
        }
    }
}
