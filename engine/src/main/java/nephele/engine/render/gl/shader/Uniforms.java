package nephele.engine.render.gl.shader;

import static org.lwjgl.opengl.GL41C.*;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.lang.reflect.Constructor;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;
import org.lwjgl.system.MemoryStack;

/**
 * The active uniforms of a linked program. A record is their declaration in Java: each component has the name of a uniform
 * and one of the types below; a list of one of them is an array; a component that is itself a record is a group of
 * uniforms of this program. Samplers and blocks are bound by their names, {@link TextureUnit} and {@link UniformBlock}.
 */
public final class Uniforms {
    private static final Map<Class<?>, Kind> KINDS = Map.of(
            Scalar.class, new Kind(GL_FLOAT, Scalar::new),
            Whole.class, new Kind(GL_INT, Whole::new),
            Vector2.class, new Kind(GL_FLOAT_VEC2, Vector2::new),
            Vector3.class, new Kind(GL_FLOAT_VEC3, Vector3::new),
            Vector4.class, new Kind(GL_FLOAT_VEC4, Vector4::new),
            WholeVector4.class, new Kind(GL_INT_VEC4, WholeVector4::new),
            Matrix4.class, new Kind(GL_FLOAT_MAT4, Matrix4::new));

    private final int program;
    private final String programName;
    /** The types of all active uniforms outside blocks, by name; an array has the name of its first element. */
    private final Map<String, Integer> types = new HashMap<>();

    /**
     * Marks a component of a record whose uniforms the program need not have, because the shader reads them only for some
     * definitions. Setting an absent uniform does nothing; an absent array has no elements.
     */
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.RECORD_COMPONENT)
    public @interface IfRead {}

    /** The record of a program that has no uniforms but samplers and blocks. */
    public record None() {}

    /** @param make makes a uniform of a program from its location */
    private record Kind(int glType, BiFunction<Integer, Integer, Object> make) {}

    public Uniforms(int program, String programName) {
        this.program = program;
        this.programName = programName;
        try (MemoryStack stack = MemoryStack.stackPush()) {
            var size = stack.mallocInt(1);
            var type = stack.mallocInt(1);
            for (int i = 0; i < glGetProgrami(program, GL_ACTIVE_UNIFORMS); i++) {
                types.put(glGetActiveUniform(program, i, size, type), type.get(0));
            }
        }
    }

    /** Binds samplers and blocks to the units and points of their names, permanently. */
    void bindByName() {
        types.forEach((name, type) -> {
            if (isSampler(type) && TextureUnit.of(name) != null) {
                sampler(name, TextureUnit.of(name));
            }
        });
        for (UniformBlock block : UniformBlock.values()) {
            int index = glGetUniformBlockIndex(program, block.inShaders());
            if (index != GL_INVALID_INDEX) {
                glUniformBlockBinding(program, index, block.binding());
            }
        }
    }

    /** A {@code float} of one program. */
    public record Scalar(int program, int location) {
        public void set(double x) {
            glProgramUniform1f(program, location, (float) x);
        }
    }

    /** An {@code int} of one program. */
    public record Whole(int program, int location) {
        public void set(int x) {
            glProgramUniform1i(program, location, x);
        }
    }

    /** A {@code vec2} of one program. */
    public record Vector2(int program, int location) {
        public void set(double x, double y) {
            glProgramUniform2f(program, location, (float) x, (float) y);
        }
    }

    /** A {@code vec3} of one program. */
    public record Vector3(int program, int location) {
        public void set(double x, double y, double z) {
            glProgramUniform3f(program, location, (float) x, (float) y, (float) z);
        }

        public void set(Vec3 v) {
            set(v.x(), v.y(), v.z());
        }

        public void setScaled(Vec3 v, double factor) {
            set(factor * v.x(), factor * v.y(), factor * v.z());
        }
    }

    /** A {@code vec4} of one program. */
    public record Vector4(int program, int location) {
        public void set(double x, double y, double z, double w) {
            glProgramUniform4f(program, location, (float) x, (float) y, (float) z, (float) w);
        }

        public void set(Vec3 xyz, double w) {
            set(xyz.x(), xyz.y(), xyz.z(), w);
        }
    }

    /** An {@code ivec4} of one program. */
    public record WholeVector4(int program, int location) {
        public void set(int x, int y, int z, int w) {
            glProgramUniform4i(program, location, x, y, z, w);
        }
    }

    /** A {@code mat4} of one program, sixteen floats column by column. */
    public record Matrix4(int program, int location) {
        public void set(float[] columns) {
            glProgramUniformMatrix4fv(program, location, false, columns);
        }
    }

    /**
     * Makes a record of uniforms.
     *
     * @throws GlException that names a uniform which the program lacks or has with another type
     */
    public <R extends Record> R record(Class<R> type) {
        return record(type, false);
    }

    /** Throws a {@link GlException} that names a sampler which has no texture unit. */
    public void requireUnits() {
        types.forEach((name, glType) -> {
            if (isSampler(glType) && TextureUnit.of(name) == null) {
                throw new GlException(programName + " has a sampler '" + name + "', which no texture unit names");
            }
        });
    }

    private <R extends Record> R record(Class<R> type, boolean mayLack) {
        RecordComponent[] components = type.getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = component(components[i], mayLack || components[i].isAnnotationPresent(IfRead.class));
        }
        try {
            Constructor<R> made = type.getDeclaredConstructor(
                    Stream.of(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
            made.setAccessible(true);
            return made.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new GlException("no uniforms can be made for " + type + ": " + e);
        }
    }

    private Object component(RecordComponent component, boolean mayLack) {
        Class<?> type = component.getType();
        String name = component.getName();
        if (type == List.class) {
            var element = ((ParameterizedType) component.getGenericType()).getActualTypeArguments()[0];
            return array((Class<?>) element, name, mayLack);
        }
        return KINDS.containsKey(type)
                ? uniform(KINDS.get(type), name, mayLack)
                : record(type.asSubclass(Record.class), mayLack);
    }

    private List<Object> array(Class<?> element, String name, boolean mayLack) {
        List<Object> all = new ArrayList<>();
        if (!mayLack || types.containsKey(name + "[0]")) {
            do {
                all.add(uniform(KINDS.get(element), name + "[" + all.size() + "]", false));
            } while (glGetUniformLocation(program, name + "[" + all.size() + "]") >= 0);
        }
        return List.copyOf(all);
    }

    private Object uniform(Kind kind, String name, boolean mayLack) {
        int location = mayLack ? glGetUniformLocation(program, name) : location(name);
        int found = types.getOrDefault(name.replaceFirst("\\[\\d+]$", "[0]"), kind.glType);
        if (location >= 0 && found != kind.glType) {
            throw new GlException(programName + " has uniform '" + name + "' with another type than its record");
        }
        return kind.make.apply(program, location);
    }

    private static boolean isSampler(int glType) {
        return switch (glType) {
            case GL_SAMPLER_2D,
                    GL_SAMPLER_3D,
                    GL_SAMPLER_CUBE,
                    GL_SAMPLER_2D_SHADOW,
                    GL_SAMPLER_2D_ARRAY,
                    GL_SAMPLER_2D_ARRAY_SHADOW,
                    GL_SAMPLER_BUFFER,
                    GL_INT_SAMPLER_BUFFER,
                    GL_UNSIGNED_INT_SAMPLER_BUFFER -> true;
            default -> false;
        };
    }

    public Scalar scalar(String name) {
        return new Scalar(program, location(name));
    }

    public Whole whole(String name) {
        return new Whole(program, location(name));
    }

    public Vector3 vector3(String name) {
        return new Vector3(program, location(name));
    }

    public Vector4 vector4(String name) {
        return new Vector4(program, location(name));
    }

    public Matrix4 matrix4(String name) {
        return new Matrix4(program, location(name));
    }

    /** Binds a sampler to another texture unit than the one that names it. */
    public void sampler(String name, TextureUnit unit) {
        glProgramUniform1i(program, location(name), unit.number());
    }

    private int location(String name) {
        int location = glGetUniformLocation(program, name);
        if (location < 0) {
            throw new GlException(programName + " has no active uniform '" + name + "'");
        }
        return location;
    }
}
