package nephele.scenes.fixed;

import java.util.Map;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.LineMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/** Draws the world's axes, with the depth test. They span the picture from any eye position. */
final class AxesDrawing implements AutoCloseable {
    /** Length of each half, as in the pictures of the course that the scenes come from. */
    private static final float LEAST_LENGTH_UNITS = 100;

    private static final float LENGTH_PER_DISTANCE = 5;

    private final GlContext gl;
    private final LineMesh lines;
    private final GlProgram<Inputs> program;

    private record Inputs(Vector3 eye, Scalar halfLength, Matrix4 clipFromRelative) {}

    AxesDrawing(GlContext gl) {
        this.gl = gl;
        lines = new LineMesh(gl, "axes", VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3), vertices());
        program = GlProgram.of(
                gl, FixedProgram.FOLDER + "axes.vert", FixedProgram.FOLDER + "axes.frag", Map.of(), Inputs.class);
    }

    private static float[] vertices() {
        float[] values = new float[36];
        for (int axis = 0; axis < 3; axis++) {
            values[12 * axis + axis] = -1;
            values[12 * axis + 3 + axis] = 1;
            values[12 * axis + 6 + axis] = 1;
            values[12 * axis + 9 + axis] = 1;
        }
        return values;
    }

    void draw(EyeNumbers eye) {
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        Inputs inputs = program.uniforms();
        inputs.eye().set(eye.x(), eye.y(), eye.z());
        double distance =
                Math.sqrt((double) eye.x() * eye.x() + (double) eye.y() * eye.y() + (double) eye.z() * eye.z());
        inputs.halfLength().set(Math.max(LEAST_LENGTH_UNITS, LENGTH_PER_DISTANCE * (float) distance));
        inputs.clipFromRelative().set(eye.clipFromRelative());
        program.use();
        lines.draw();
    }

    @Override
    public void close() {
        lines.close();
    }
}
