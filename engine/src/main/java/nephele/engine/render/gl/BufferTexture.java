package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import nephele.engine.render.gl.shader.TextureUnit;

/**
 * An array that shaders read by index: texels of four floats ({@code samplerBuffer}) or integers ({@code
 * usamplerBuffer}).
 */
public final class BufferTexture implements GlObject {
    private static final int FLOATS_PER_TEXEL = 4;

    private final GlContext gl;
    private final String name;
    private final GlHandle buffer;
    private final GlHandle texture;

    private BufferTexture(GlContext gl, String name) {
        this.gl = gl;
        this.name = name;
        buffer = new GlHandle(gl, GlKind.BUFFER, name, glGenBuffers(), id -> glDeleteBuffers(id));
        texture = new GlHandle(gl, GlKind.TEXTURE, name, glGenTextures(), id -> glDeleteTextures(id));
        glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
    }

    /**
     * Creates a texture of floats.
     *
     * @param values four for each texel
     */
    public static BufferTexture ofFloats(GlContext gl, String name, float[] values) {
        BufferTexture created = new BufferTexture(gl, name);
        created.requireRoom(values.length / FLOATS_PER_TEXEL);
        glBufferData(GL_TEXTURE_BUFFER, values, GL_STATIC_DRAW);
        created.attach(GL_RGBA32F);
        return created;
    }

    /**
     * Creates a texture of integers.
     *
     * @param values one for each texel, not negative
     */
    public static BufferTexture ofIntegers(GlContext gl, String name, int[] values) {
        BufferTexture created = new BufferTexture(gl, name);
        created.requireRoom(values.length);
        glBufferData(GL_TEXTURE_BUFFER, values, GL_STATIC_DRAW);
        created.attach(GL_R32UI);
        return created;
    }

    /** Creates a texture of floats that is replaced often, four for each texel. */
    public static BufferTexture changing(GlContext gl, String name) {
        BufferTexture created = new BufferTexture(gl, name);
        glBufferData(GL_TEXTURE_BUFFER, 16, GL_STREAM_DRAW);
        created.attach(GL_RGBA32F);
        return created;
    }

    /** Creates a texture of integers that is replaced often, one for each texel. */
    public static BufferTexture changingIntegers(GlContext gl, String name) {
        BufferTexture created = new BufferTexture(gl, name);
        glBufferData(GL_TEXTURE_BUFFER, 4, GL_STREAM_DRAW);
        created.attach(GL_R32UI);
        return created;
    }

    /** Replaces the whole content by integers; draws that still read the old storage keep it. */
    public void upload(IntBuffer values) {
        requireRoom(values.remaining());
        glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
        glBufferData(GL_TEXTURE_BUFFER, values, GL_STREAM_DRAW);
    }

    /** Replaces the whole content; draws that still read the old storage keep it. */
    public void upload(FloatBuffer values) {
        requireRoom(values.remaining() / FLOATS_PER_TEXEL);
        glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
        glBufferData(GL_TEXTURE_BUFFER, values, GL_STREAM_DRAW);
        if (gl.state().listener() != null) {
            float[] copy = new float[values.remaining()];
            values.duplicate().get(copy);
            gl.state().listener().uploaded(buffer.id(), copy);
        }
    }

    /** Replaces texels from {@code first} on, four floats each, within the size of the last upload. */
    public void uploadFrom(int first, FloatBuffer values) {
        glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
        glBufferSubData(GL_TEXTURE_BUFFER, (long) FLOATS_PER_TEXEL * Float.BYTES * first, values);
    }

    /**
     * Throws if the texels exceed the limit: OpenGL guarantees 65,536; most machines have thousands of times as many.
     */
    private void requireRoom(int texels) {
        if (texels > gl.limits().maxBufferTexels()) {
            throw new GlUnavailableException(name + " take " + texels + " texels; this machine's OpenGL holds "
                    + gl.limits().maxBufferTexels()
                    + " in a list: show fewer at once, or use another graphics driver.");
        }
    }

    private void attach(int format) {
        bind(TextureUnit.UPLOAD);
        glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
    }

    public void bind(TextureUnit unit) {
        gl.bindings().texture(unit, GL_TEXTURE_BUFFER, texture.id());
    }

    @Override
    public void close() {
        texture.close();
        buffer.close();
    }
}
