package nephele.engine.render.fixed;

import java.util.Map;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.LineMesh;
import nephele.engine.render.gl.ShaderSource;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.render.gl.Uniforms.Matrix4;
import nephele.engine.render.gl.Uniforms.Vector3;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;

/** The world's axes, which take part in the depth test. */
final class AxesDrawing implements AutoCloseable {
    private final GlContext gl;
    private final LineMesh lines;
    private final GlProgram<Inputs> program;

    private record Inputs(Vector3 eye, Matrix4 clipFromRelative) {
        static Inputs of(Uniforms uniforms) {
            return new Inputs(uniforms.vector3("eye"), uniforms.matrix4("clipFromRelative"));
        }
    }

    /** @param length of each half */
    AxesDrawing(GlContext gl, double length) {
        this.gl = gl;
        lines = new LineMesh(gl, "axes", VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3), vertices((float) length));
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FixedProgram.FOLDER + "axes.vert", Map.of()),
                ShaderSource.load(FixedProgram.FOLDER + "axes.frag", Map.of()),
                Inputs::of);
    }

    private static float[] vertices(float length) {
        float[] values = new float[36];
        for (int axis = 0; axis < 3; axis++) {
            values[12 * axis + axis] = -length;
            values[12 * axis + 3 + axis] = 1;
            values[12 * axis + 6 + axis] = length;
            values[12 * axis + 9 + axis] = 1;
        }
        return values;
    }

    void draw(EyeNumbers eye) {
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        Inputs inputs = program.uniforms();
        inputs.eye().set(eye.x(), eye.y(), eye.z());
        inputs.clipFromRelative().set(eye.clipFromRelative());
        program.use();
        lines.draw();
    }

    @Override
    public void close() {
        lines.close();
        program.close();
    }
}
