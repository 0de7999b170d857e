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
import nephele.engine.render.gl.shader.Uniforms.Vector3;

/** Draws a small labelled cross of the axes' directions in the upper right corner, over everything. */
final class AxesCross implements AutoCloseable {
    private static final float LENGTH_PIXELS = 34;

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

    private record Inputs(Matrix4 clipFromRelative, Vector3 clipPerPixel) {}

    AxesCross(GlContext gl) {
        this.gl = gl;
        var format = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3, Attribute.FLOAT2);
        lines = new LineMesh(gl, "cross of axes", format, vertices());
        program = GlProgram.of(
                gl, FixedProgram.FOLDER + "axes-cross.vert", FixedProgram.FOLDER + "axes.frag", Map.of(), Inputs.class);
    }

    private static float[] vertices() {
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

    void draw(EyeNumbers eye, RenderTarget target) {
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        program.use();
        program.uniforms().clipFromRelative().set(eye.clipFromRelative());
        program.uniforms().clipPerPixel().set(2f / target.width(), 2f / target.height(), LENGTH_PIXELS);
        lines.draw();
    }

    @Override
    public void close() {
        lines.close();
    }
}
