package nephele.scenes.fixed;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
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
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/**
 * Draws the world's axes, with the depth test: they span the picture from any eye position. Beside them a small cross
 * shows their directions where an axis is seen as a point.
 */
final class AxesDrawing implements AutoCloseable {
    /** Length of each half, as in the pictures of the course that the scenes come from. */
    private static final float LEAST_LENGTH_UNITS = 100;

    private static final float LENGTH_PER_DISTANCE = 5;

    private static final float CROSS_PIXELS = 34;

    /** The labels lie beyond the axes' ends. */
    private static final float LABEL_AT = 1.35f;

    /** Strokes of the letters X, Y and Z: two points each, pixels from the letter's middle. */
    private static final float[][] LETTERS = {
        {-4, -5, 4, 5, -4, 5, 4, -5}, {-4, 5, 0, 0, 4, 5, 0, 0, 0, 0, 0, -5}, {-4, 5, 4, 5, 4, 5, -4, -5, -4, -5, 4, -5}
    };

    /** Lines are a pixel wide: a stroke is three of them. */
    private static final float[][] THICKNESS = {{0, 0}, {1, 0}, {0, 1}};

    /** The axes' colours in lines too thin for full blue. */
    private static final float[][] COLOURS = {{1, 0.25f, 0.2f}, {0.3f, 1, 0.3f}, {0.4f, 0.6f, 1}};

    private final GlContext gl;
    private final LineMesh lines;
    private final GlProgram<Inputs> program;

    private final LineMesh cross;
    private final GlProgram<CrossInputs> crossProgram;

    private record CrossInputs(Matrix4 clipFromRelative, Vector3 clipPerPixel) {}

    private record Inputs(Vector3 eye, Scalar halfLength, Matrix4 clipFromRelative) {}

    AxesDrawing(GlContext gl) {
        this.gl = gl;
        lines = new LineMesh(gl, "axes", VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3), vertices());
        program = GlProgram.of(
                gl, FixedProgram.FOLDER + "axes.vert", FixedProgram.FOLDER + "axes.frag", Map.of(), Inputs.class);
        var format = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3, Attribute.FLOAT2);
        cross = new LineMesh(gl, "cross of axes", format, crossVertices());
        crossProgram = GlProgram.of(
                gl,
                FixedProgram.FOLDER + "axes-cross.vert",
                FixedProgram.FOLDER + "axes.frag",
                Map.of(),
                CrossInputs.class);
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

    private static float[] crossVertices() {
        List<Float> values = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            for (float[] aside : THICKNESS) {
                add(values, axis, 0, aside[0], aside[1]);
                add(values, axis, 1, aside[0], aside[1]);
                for (int point = 0; point < LETTERS[axis].length; point += 2) {
                    add(values, axis, LABEL_AT, LETTERS[axis][point] + aside[0], LETTERS[axis][point + 1] + aside[1]);
                }
            }
        }
        float[] array = new float[values.size()];
        for (int i = 0; i < array.length; i++) {
            array[i] = values.get(i);
        }
        return array;
    }

    private static void add(List<Float> values, int axis, float along, float x, float y) {
        for (int i = 0; i < 3; i++) {
            values.add(i == axis ? along : 0);
        }
        for (int i = 0; i < 3; i++) {
            values.add(COLOURS[axis][i]);
        }
        values.add(x);
        values.add(y);
    }

    /** Draws a small labelled cross of the axes' directions in the upper right corner, over everything. */
    void drawCross(EyeNumbers eye, RenderTarget target) {
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        crossProgram.use();
        crossProgram.uniforms().clipFromRelative().set(eye.clipFromRelative());
        crossProgram.uniforms().clipPerPixel().set(2f / target.width(), 2f / target.height(), CROSS_PIXELS);
        cross.draw();
    }

    @Override
    public void close() {
        lines.close();
        cross.close();
    }
}
