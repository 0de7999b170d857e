package nephele.engine.render.gl.shader;

import static org.lwjgl.opengl.GL41C.*;

/**
 * Looks up uniforms by name while a program is created; throws for a name that the program does not use. The tables of
 * the air, which every shader of a surface may read, have their units at once.
 */
public final class Uniforms {
    private final int program;
    private final String programName;

    public Uniforms(int program, String programName) {
        this.program = program;
        this.programName = programName;
        tie("airTable", TextureUnit.AIR);
        tie("shaftTable", TextureUnit.SHAFTS);
    }

    private void tie(String sampler, TextureUnit unit) {
        int location = glGetUniformLocation(program, sampler);
        if (location >= 0) {
            glProgramUniform1i(program, location, unit.number());
        }
    }

    /** A {@code float} of one program. */
    public record Scalar(int program, int location) {
        public void set(float x) {
            glProgramUniform1f(program, location, x);
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
        public void set(float x, float y) {
            glProgramUniform2f(program, location, x, y);
        }
    }

    /** A {@code vec3} of one program. */
    public record Vector3(int program, int location) {
        public void set(float x, float y, float z) {
            glProgramUniform3f(program, location, x, y, z);
        }
    }

    /** A {@code vec4} of one program. */
    public record Vector4(int program, int location) {
        public void set(float x, float y, float z, float w) {
            glProgramUniform4f(program, location, x, y, z, w);
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

    public Scalar scalar(String name) {
        return new Scalar(program, location(name));
    }

    public Whole whole(String name) {
        return new Whole(program, location(name));
    }

    public Vector2 vector2(String name) {
        return new Vector2(program, location(name));
    }

    public Vector3 vector3(String name) {
        return new Vector3(program, location(name));
    }

    public Vector4 vector4(String name) {
        return new Vector4(program, location(name));
    }

    public WholeVector4 wholeVector4(String name) {
        return new WholeVector4(program, location(name));
    }

    public Matrix4 matrix4(String name) {
        return new Matrix4(program, location(name));
    }

    /** Binds a sampler to a texture unit permanently. */
    public void sampler(String name, TextureUnit unit) {
        glProgramUniform1i(program, location(name), unit.number());
    }

    /** Returns true if the program reads a uniform. */
    public boolean reads(String name) {
        return glGetUniformLocation(program, name) >= 0;
    }

    /** Binds a sampler to a texture unit permanently if the program reads it. */
    public void samplerIfRead(String name, TextureUnit unit) {
        tie(name, unit);
    }

    /** Binds a uniform block to a binding point permanently. */
    public void block(String name, int bindingPoint) {
        int index = glGetUniformBlockIndex(program, name);
        if (index == GL_INVALID_INDEX) {
            throw new GlException(programName + " has no active uniform block '" + name + "'");
        }
        glUniformBlockBinding(program, index, bindingPoint);
    }

    private int location(String name) {
        int location = glGetUniformLocation(program, name);
        if (location < 0) {
            throw new GlException(programName + " has no active uniform '" + name + "'");
        }
        return location;
    }
}
