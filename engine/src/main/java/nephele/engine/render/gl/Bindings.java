package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.util.Arrays;
import nephele.engine.render.gl.shader.TextureUnit;

/** The bound objects and the viewport; calls OpenGL only for differences. */
final class Bindings {
    private final int[] textures = new int[TextureUnit.COUNT];
    private int activeUnit;
    private int program;
    private int vertexArray;
    private int framebuffer;
    private int viewportWidth = -1;
    private int viewportHeight = -1;

    void program(int id) {
        if (program != id) {
            glUseProgram(id);
            program = id;
        }
    }

    void vertexArray(int id) {
        if (vertexArray != id) {
            glBindVertexArray(id);
            vertexArray = id;
        }
    }

    void texture(TextureUnit at, int target, int id) {
        int unit = at.number();
        if (textures[unit] != id) {
            if (activeUnit != unit) {
                glActiveTexture(GL_TEXTURE0 + unit);
                activeUnit = unit;
            }
            glBindTexture(target, id);
            textures[unit] = id;
        }
    }

    /** Binds for drawing and reading, and sets the viewport to the whole size. */
    void framebuffer(int id, int width, int height) {
        if (framebuffer != id) {
            glBindFramebuffer(GL_FRAMEBUFFER, id);
            framebuffer = id;
        }
        if (viewportWidth != width || viewportHeight != height) {
            glViewport(0, 0, width, height);
            viewportWidth = width;
            viewportHeight = height;
        }
    }

    /** Removes a deleted object: OpenGL has unbound its name, and a new object may receive the same one. */
    void forget(GlKind kind, int id) {
        switch (kind) {
            case VERTEX_ARRAY -> vertexArray = vertexArray == id ? 0 : vertexArray;
            case FRAMEBUFFER -> framebuffer = framebuffer == id ? 0 : framebuffer;
            case TEXTURE -> {
                for (int unit = 0; unit < TextureUnit.COUNT; unit++) {
                    textures[unit] = textures[unit] == id ? 0 : textures[unit];
                }
            }
            case BUFFER, RENDERBUFFER, QUERY -> {}
        }
    }

    void assumeNothing() {
        Arrays.fill(textures, -1);
        activeUnit = -1;
        program = -1;
        vertexArray = -1;
        framebuffer = -1;
        viewportWidth = -1;
    }
}
