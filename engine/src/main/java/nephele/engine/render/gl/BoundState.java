package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.BufferUtils;

/** The state that a draw call depends on, read back from OpenGL, as steps that can be compared and repeated. */
record BoundState(List<Step> steps) {
    static final BoundState NOTHING = new BoundState(List.of());

    private static final int UNIFORM_BINDINGS = 8;

    private static final int[] SWITCHES = {
        GL_DEPTH_TEST,
        GL_BLEND,
        GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_SAMPLE_ALPHA_TO_ONE,
        GL_CULL_FACE,
        GL_POLYGON_OFFSET_FILL,
        GL_SCISSOR_TEST,
        GL_STENCIL_TEST,
        GL_DEPTH_CLAMP,
        GL_CLIP_DISTANCE0,
        GL_CLIP_DISTANCE0 + 1,
        GL_CLIP_DISTANCE0 + 2
    };

    /** A setting; equal keys and values need not be set again. */
    private record Step(String key, List<Number> value, Runnable set) {}

    static BoundState read() {
        List<Step> steps = new ArrayList<>();
        readFramebuffer(steps);
        readSwitches(steps);
        int program = glGetInteger(GL_CURRENT_PROGRAM);
        add(steps, "program", () -> glUseProgram(program), program);
        int vertexArray = glGetInteger(GL_VERTEX_ARRAY_BINDING);
        add(steps, "vertex array", () -> glBindVertexArray(vertexArray), vertexArray);
        readTextures(steps);
        readUniformBlocks(steps);
        if (program != 0) {
            readUniforms(steps, program);
        }
        return new BoundState(steps);
    }

    /** Appends the calls that change the state {@code before} to this one, and their text. */
    void changesFrom(BoundState before, List<Runnable> calls, List<String> words) {
        Map<String, List<Number>> set = new HashMap<>();
        before.steps.forEach(step -> set.put(step.key, step.value));
        for (Step step : steps) {
            if (!step.value.equals(set.get(step.key))) {
                calls.add(step.set);
                words.add(step.key + " " + step.value);
            }
        }
    }

    /**
     * Returns the state after {@code before} and this: other programs' uniforms and unbound buffers keep their values.
     */
    BoundState after(BoundState before) {
        Map<String, Step> set = new LinkedHashMap<>();
        before.steps.forEach(step -> set.put(step.key, step));
        steps.forEach(step -> set.put(step.key, step));
        return new BoundState(List.copyOf(set.values()));
    }

    private static void add(List<Step> steps, String key, Runnable set, Number... value) {
        steps.add(new Step(key, List.of(value), set));
    }

    private static void readFramebuffer(List<Step> steps) {
        int framebuffer = glGetInteger(GL_FRAMEBUFFER_BINDING);
        int[] scissor = new int[4];
        glGetIntegerv(GL_SCISSOR_BOX, scissor);
        add(
                steps,
                "scissor",
                () -> glScissor(scissor[0], scissor[1], scissor[2], scissor[3]),
                scissor[0],
                scissor[1],
                scissor[2],
                scissor[3]);
        int[] viewport = new int[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        add(steps, "framebuffer", () -> glBindFramebuffer(GL_FRAMEBUFFER, framebuffer), framebuffer);
        add(steps, "viewport", () -> glViewport(0, 0, viewport[2], viewport[3]), viewport[2], viewport[3]);
    }

    private static void readSwitches(List<Step> steps) {
        for (int capability : SWITCHES) {
            boolean on = glIsEnabled(capability);
            add(
                    steps,
                    "switch " + capability,
                    on ? () -> glEnable(capability) : () -> glDisable(capability),
                    on ? 1 : 0);
        }
        int depthFunction = glGetInteger(GL_DEPTH_FUNC);
        add(steps, "depth function", () -> glDepthFunc(depthFunction), depthFunction);
        boolean depthMask = glGetBoolean(GL_DEPTH_WRITEMASK);
        add(steps, "depth mask", () -> glDepthMask(depthMask), depthMask ? 1 : 0);
        boolean colour = colourMask();
        add(steps, "colour mask", () -> glColorMask(colour, colour, colour, colour), colour ? 1 : 0);
        int culled = glGetInteger(GL_CULL_FACE_MODE);
        add(steps, "culled faces", () -> glCullFace(culled), culled);
        // Drivers return values for front and back.
        int[] fill = new int[2];
        glGetIntegerv(GL_POLYGON_MODE, fill);
        add(steps, "fill", () -> glPolygonMode(GL_FRONT_AND_BACK, fill[0]), fill[0]);
        readOpenings(steps);
        int source = glGetInteger(GL_BLEND_SRC_RGB);
        int destination = glGetInteger(GL_BLEND_DST_RGB);
        int alphaSource = glGetInteger(GL_BLEND_SRC_ALPHA);
        int alphaDestination = glGetInteger(GL_BLEND_DST_ALPHA);
        Runnable blend = () -> glBlendFuncSeparate(source, destination, alphaSource, alphaDestination);
        add(steps, "blend function", blend, source, destination, alphaSource, alphaDestination);
    }

    /** Reads the additional state with which openings are drawn. */
    private static void readOpenings(List<Step> steps) {
        int reference = glGetInteger(GL_STENCIL_REF);
        int whereDrawn = glGetInteger(GL_STENCIL_PASS_DEPTH_PASS);
        int function = glGetInteger(GL_STENCIL_FUNC);
        Runnable stencil = () -> {
            glStencilFunc(function, reference, 0xff);
            glStencilOp(GL_KEEP, GL_KEEP, whereDrawn);
        };
        add(steps, "stencil", stencil, function, reference, whereDrawn);
        float factor = glGetFloat(GL_POLYGON_OFFSET_FACTOR);
        float units = glGetFloat(GL_POLYGON_OFFSET_UNITS);
        add(steps, "polygon offset", () -> glPolygonOffset(factor, units), factor, units);
        float[] range = new float[2];
        glGetFloatv(GL_DEPTH_RANGE, range);
        add(steps, "depth range", () -> glDepthRange(range[0], range[1]), range[0], range[1]);
    }

    private static boolean colourMask() {
        ByteBuffer mask = BufferUtils.createByteBuffer(4);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask);
        return mask.get(0) != 0;
    }

    private static void readTextures(List<Step> steps) {
        int[][] targets = {
            {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
            {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
            {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
            {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
            {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER}
        };
        int active = glGetInteger(GL_ACTIVE_TEXTURE);
        for (int unit = 0; unit < TextureUnit.COUNT; unit++) {
            int name = GL_TEXTURE0 + unit;
            glActiveTexture(name);
            for (int[] target : targets) {
                int texture = glGetInteger(target[1]);
                if (texture != 0) {
                    Runnable bind = () -> {
                        glActiveTexture(name);
                        glBindTexture(target[0], texture);
                    };
                    add(steps, "texture " + unit + " " + target[0], bind, texture);
                }
            }
        }
        glActiveTexture(active);
    }

    private static void readUniformBlocks(List<Step> steps) {
        for (int binding = 0; binding < UNIFORM_BINDINGS; binding++) {
            int buffer = glGetIntegeri(GL_UNIFORM_BUFFER_BINDING, binding);
            if (buffer == 0) {
                continue;
            }
            int point = binding;
            add(steps, "block " + binding, () -> glBindBufferBase(GL_UNIFORM_BUFFER, point, buffer), buffer);
            glBindBuffer(GL_UNIFORM_BUFFER, buffer);
            float[] content = new float[glGetBufferParameteri(GL_UNIFORM_BUFFER, GL_BUFFER_SIZE) / 4];
            glGetBufferSubData(GL_UNIFORM_BUFFER, 0, content);
            Runnable upload = () -> {
                glBindBuffer(GL_UNIFORM_BUFFER, buffer);
                glBufferSubData(GL_UNIFORM_BUFFER, 0, content);
            };
            add(steps, "content " + buffer, upload, Arrays.hashCode(content));
        }
    }

    private static void readUniforms(List<Step> steps, int program) {
        int uniforms = glGetProgrami(program, GL_ACTIVE_UNIFORMS);
        var size = BufferUtils.createIntBuffer(1);
        var type = BufferUtils.createIntBuffer(1);
        for (int i = 0; i < uniforms; i++) {
            String name = glGetActiveUniform(program, i, size, type);
            for (int element = 0; element < size.get(0); element++) {
                String each = name.replaceFirst("\\[0]$", "[" + element + "]");
                int location = glGetUniformLocation(program, each);
                // A uniform without location is in a block.
                if (location >= 0) {
                    readUniform(steps, program, location, type.get(0));
                }
            }
        }
    }

    private static void readUniform(List<Step> steps, int program, int location, int type) {
        String key = "uniform " + program + " " + location;
        if (type == GL_INT_VEC4) {
            int[] v = new int[4];
            glGetUniformiv(program, location, v);
            add(
                    steps,
                    key,
                    () -> glProgramUniform4i(program, location, v[0], v[1], v[2], v[3]),
                    v[0],
                    v[1],
                    v[2],
                    v[3]);
            return;
        }
        int components = floats(type);
        if (components == 0) {
            int value = glGetUniformi(program, location);
            add(steps, key, () -> glProgramUniform1i(program, location, value), value);
            return;
        }
        float[] v = new float[components];
        glGetUniformfv(program, location, v);
        Number[] value = new Number[components];
        Arrays.setAll(value, at -> v[at]);
        add(steps, key, () -> setFloats(program, location, v), value);
    }

    /** Returns the number of floats of a type; 0 for single integers, booleans and samplers. */
    private static int floats(int type) {
        return switch (type) {
            case GL_FLOAT -> 1;
            case GL_FLOAT_VEC2 -> 2;
            case GL_FLOAT_VEC3 -> 3;
            case GL_FLOAT_VEC4 -> 4;
            case GL_FLOAT_MAT4 -> 16;
            case GL_INT,
                    GL_BOOL,
                    GL_SAMPLER_2D,
                    GL_SAMPLER_2D_ARRAY,
                    GL_SAMPLER_CUBE,
                    GL_SAMPLER_3D,
                    GL_SAMPLER_BUFFER -> 0;
            case GL_SAMPLER_2D_SHADOW, GL_SAMPLER_2D_ARRAY_SHADOW, GL_UNSIGNED_INT_SAMPLER_BUFFER -> 0;
            default -> throw new IllegalStateException("no bare twin repeats uniforms of type " + type);
        };
    }

    private static void setFloats(int program, int location, float[] v) {
        switch (v.length) {
            case 1 -> glProgramUniform1f(program, location, v[0]);
            case 2 -> glProgramUniform2f(program, location, v[0], v[1]);
            case 3 -> glProgramUniform3f(program, location, v[0], v[1], v[2]);
            case 4 -> glProgramUniform4f(program, location, v[0], v[1], v[2], v[3]);
            default -> glProgramUniformMatrix4fv(program, location, false, v);
        }
    }
}
