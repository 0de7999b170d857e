package nephele.engine.render.line;

import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.LineMesh;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;

/** Many lines of the world that stay on the GPU, a pixel wide, in one colour. */
public final class WorldEdges implements AutoCloseable {
    private final GlContext gl;
    private final Vec3 origin;
    private final LineMesh lines;
    private final GlProgram<Inputs> program;

    private record Inputs(Matrix4 clipFromRelative, Vector3 originFromEye, Vector4 lineColour) {}

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
        program = GlProgram.of(
                gl, LineDrawing.FOLDER + "edges.vert", LineDrawing.FOLDER + "edges.frag", Map.of(), Inputs.class);
    }

    /** Draws over a picture, whose depth may hide what is behind its surfaces. */
    public void draw(LineProjection projection, DisplayColour colour, LineLayer layer, RenderTarget picture) {
        if (lines == null) {
            return;
        }
        picture.bind();
        Depth depth = layer == LineLayer.BEHIND_SURFACES ? Depth.LESS_OR_EQUAL : Depth.OFF;
        gl.state().set(depth, Blend.OVER, Cull.NONE);
        program.use();
        program.uniforms().clipFromRelative().set(projection.matrix());
        program.uniforms().originFromEye().set(projection.fromEye(origin));
        program.uniforms().lineColour().set(colour.red(), colour.green(), colour.blue(), colour.alpha());
        lines.draw();
    }

    @Override
    public void close() {
        if (lines != null) {
            lines.close();
        }
    }
}
