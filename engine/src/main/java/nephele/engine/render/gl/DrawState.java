package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.util.Arrays;

/** What is bound and switched on; calls OpenGL only for what differs. Also counts what a frame submits. */
public final class DrawState {
    /** Depth test and write. */
    public enum Depth {
        OFF,
        LESS_AND_WRITE,
        /** Lays down depth for later passes and keeps the colour. */
        LESS_AND_WRITE_ONLY_DEPTH,
        /** Passes at equal depth, writes nothing: what lies at the far plane. */
        LESS_OR_EQUAL
    }

    /** How a fragment joins what is there. */
    public enum Blend {
        REPLACE,
        /** Source alpha over destination; the destination keeps its alpha. */
        OVER
    }

    /** Which faces are dropped. */
    public enum Cull {
        NONE,
        BACK
    }

    static final int TEXTURE_UNITS = 16;

    private final int[] textures = new int[TEXTURE_UNITS];
    private int activeUnit;
    private int program;
    private int vertexArray;
    private int framebuffer;
    private int viewportWidth = -1;
    private int viewportHeight = -1;
    private Depth depth;
    private Blend blend;
    private Cull cull;
    private long draws;
    private long triangles;
    private DrawListener listener;

    /** Sets the fixed-function switches. */
    public void set(Depth newDepth, Blend newBlend, Cull newCull) {
        if (depth != newDepth) {
            setDepth(newDepth);
        }
        if (blend != newBlend) {
            setBlend(newBlend);
        }
        if (cull != newCull) {
            toggle(GL_CULL_FACE, newCull == Cull.BACK);
            cull = newCull;
        }
    }

    private void setDepth(Depth newDepth) {
        toggle(GL_DEPTH_TEST, newDepth != Depth.OFF);
        boolean depthOnly = newDepth == Depth.LESS_AND_WRITE_ONLY_DEPTH;
        glDepthMask(newDepth == Depth.LESS_AND_WRITE || depthOnly);
        glColorMask(!depthOnly, !depthOnly, !depthOnly, !depthOnly);
        glDepthFunc(newDepth == Depth.LESS_OR_EQUAL ? GL_LEQUAL : GL_LESS);
        depth = newDepth;
    }

    private void setBlend(Blend newBlend) {
        toggle(GL_BLEND, newBlend != Blend.REPLACE);
        if (newBlend == Blend.OVER) {
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
        }
        blend = newBlend;
    }

    private static void toggle(int capability, boolean on) {
        if (on) {
            glEnable(capability);
        } else {
            glDisable(capability);
        }
    }

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

    void texture(int unit, int target, int id) {
        if (textures[unit] != id) {
            if (activeUnit != unit) {
                glActiveTexture(GL_TEXTURE0 + unit);
                activeUnit = unit;
            }
            glBindTexture(target, id);
            textures[unit] = id;
        }
    }

    /** Binds for drawing and reading, with the viewport over all of it. */
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

    /** A clear obeys the depth mask: call before clearing depth. */
    void allowDepthClear() {
        if (depth != Depth.LESS_AND_WRITE) {
            setDepth(Depth.LESS_AND_WRITE);
        }
    }

    /** After deletion OpenGL has unbound the name; a new object may get the same one. */
    void forget(GlKind kind, int id) {
        switch (kind) {
            case PROGRAM -> program = program == id ? 0 : program;
            case VERTEX_ARRAY -> vertexArray = vertexArray == id ? 0 : vertexArray;
            case FRAMEBUFFER -> framebuffer = framebuffer == id ? 0 : framebuffer;
            case TEXTURE -> {
                for (int unit = 0; unit < TEXTURE_UNITS; unit++) {
                    textures[unit] = textures[unit] == id ? 0 : textures[unit];
                }
            }
            case BUFFER, RENDERBUFFER, QUERY -> {}
        }
    }

    /** Call when foreign code (another toolkit, the bare twin) has used the context. */
    public void assumeNothing() {
        Arrays.fill(textures, -1);
        activeUnit = -1;
        program = -1;
        vertexArray = -1;
        framebuffer = -1;
        viewportWidth = -1;
        depth = null;
        blend = null;
        cull = null;
    }

    /** {@code null} to stop listening. */
    void listen(DrawListener newListener) {
        listener = newListener;
    }

    /** {@code null} outside of recordings. */
    DrawListener listener() {
        return listener;
    }

    void drawn(int calls, long drawnTriangles) {
        draws += calls;
        triangles += drawnTriangles;
    }

    /** Draw calls since {@link #resetCounts}; one multi-draw counts as one. */
    public long draws() {
        return draws;
    }

    public long triangles() {
        return triangles;
    }

    public void resetCounts() {
        draws = 0;
        triangles = 0;
    }
}
