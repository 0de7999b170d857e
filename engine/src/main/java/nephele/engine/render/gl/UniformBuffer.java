package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import nephele.engine.render.gl.shader.GlException;
import nephele.engine.render.gl.shader.UniformBlock;

/** The storage of a uniform block, std140; the caller provides floats in multiples of four. */
public final class UniformBuffer implements GlObject {
    private final GlHandle handle;
    private final int floats;

    public UniformBuffer(GlContext gl, String name, int floats) {
        this.floats = floats;
        handle = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        glBindBuffer(GL_UNIFORM_BUFFER, handle.id());
        glBufferData(GL_UNIFORM_BUFFER, 4L * floats, GL_DYNAMIC_DRAW);
    }

    /** Replaces the whole content. */
    public void upload(float[] values) {
        if (values.length != floats) {
            throw new GlException(handle.name() + " holds " + floats + " floats, not " + values.length);
        }
        glBindBuffer(GL_UNIFORM_BUFFER, handle.id());
        glBufferSubData(GL_UNIFORM_BUFFER, 0, values);
    }

    public void bind(UniformBlock block) {
        glBindBufferBase(GL_UNIFORM_BUFFER, block.binding(), handle.id());
    }

    @Override
    public void close() {
        handle.close();
    }
}
