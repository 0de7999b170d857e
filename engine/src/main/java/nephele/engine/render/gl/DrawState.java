package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/**
 * What is switched on, and by its {@link Bindings} what is bound; calls OpenGL only for what differs. Also counts what
 * a frame submits.
 */
public final class DrawState {
    /** Depth test and write, and whether colour is written. */
    public enum Depth {
        OFF(GL_LESS, false, true),
        LESS_AND_WRITE(GL_LESS, true, true),
        /** Lays down depth for later passes and keeps the colour. */
        LESS_AND_WRITE_ONLY_DEPTH(GL_LESS, true, false),
        /** Passes at equal depth, writes no depth: what lies at the far plane. */
        LESS_OR_EQUAL(GL_LEQUAL, false, true),
        /** Where this very surface is the nearest. */
        EQUAL(GL_EQUAL, false, true),
        /** As {@link #EQUAL}, keeping depth and colour: only the stencil hears of it. */
        EQUAL_ONLY_STENCIL(GL_EQUAL, false, false),
        ALWAYS_AND_WRITE(GL_ALWAYS, true, true),
        ALWAYS_AND_WRITE_ONLY_DEPTH(GL_ALWAYS, true, false);

        private final int function;
        private final boolean depthWritten;
        private final boolean colourWritten;

        Depth(int function, boolean depthWritten, boolean colourWritten) {
            this.function = function;
            this.depthWritten = depthWritten;
            this.colourWritten = colourWritten;
        }
    }

    /** Which pixels are drawn to by the number in their stencil, and what becomes of it. */
    public enum Stencil {
        /** All, and it stays. */
        OFF(GL_KEEP),
        /** Those that hold the reference. */
        EQUAL(GL_KEEP),
        /** Those that hold the reference; one more where depth passes too. */
        EQUAL_COUNT_UP(GL_INCR),
        /** Those that hold the reference; one less where depth passes too. */
        EQUAL_COUNT_DOWN(GL_DECR);

        private final int whereDrawn;

        Stencil(int whereDrawn) {
            this.whereDrawn = whereDrawn;
        }
    }

    /** How a polygon's depth comes about. */
    public enum DepthOf {
        SURFACE,
        /** Of an opening in a wall: before the wall by the least that tells them apart, never cut by near and far. */
        OPENING,
        /** As {@link #OPENING} of a whole face: before it by what snapping the corners of both to the pixel grid can do. */
        WHOLE_FACE,
        /** Farthest, wherever it lies. */
        FARTHEST
    }

    /** How a fragment joins what is there. */
    public enum Blend {
        REPLACE,
        /** Source alpha over destination; the destination keeps its alpha. */
        OVER,
        /** Source and destination; the destination keeps its alpha. */
        ADD,
        /** Source, whose colours hold its alpha already, over destination, alpha too: layers that are laid over later. */
        PREMULTIPLIED_OVER
    }

    /** Which faces are dropped. */
    public enum Cull {
        NONE,
        BACK,
        /** As {@link #BACK} of what a mirror has turned inside out. */
        FRONT
    }

    /** How the corners of a triangle that faces the eye follow one another in the picture. */
    public enum FrontFace {
        COUNTER_CLOCKWISE(GL_CCW),
        /** In a view that is mirrored. */
        CLOCKWISE(GL_CW);

        private final int mode;

        FrontFace(int mode) {
            this.mode = mode;
        }
    }

    /** What is drawn of a triangle. */
    public enum Fill {
        WHOLE(GL_FILL),
        /** Its three edges, a pixel wide; which faces are dropped is as ever. */
        EDGES(GL_LINE);

        private final int mode;

        Fill(int mode) {
            this.mode = mode;
        }
    }

    /** The view's plane and a straddling thing's two. */
    static final int MOST_CLIP_DISTANCES = 3;

    private final Bindings bindings = new Bindings();
    private final Scissor scissor = new Scissor();
    private Depth depth;
    private Blend blend;
    private Cull cull;
    private int clipDistances;
    private Stencil stencil = Stencil.OFF;
    private int stencilReference;
    private DepthOf depthOf = DepthOf.SURFACE;
    private Fill fill = Fill.WHOLE;
    private FrontFace frontFace = FrontFace.COUNTER_CLOCKWISE;
    private long draws;
    private long triangles;
    private DrawListener listener;

    /** Sets the fixed-function switches, without clip distances. */
    public void set(Depth newDepth, Blend newBlend, Cull newCull) {
        set(newDepth, newBlend, newCull, 0);
    }

    /** @param newClipDistances so many elements of {@code gl_ClipDistance}, from the first on, cut what is drawn */
    public void set(Depth newDepth, Blend newBlend, Cull newCull, int newClipDistances) {
        if (depth != newDepth) {
            setDepth(newDepth);
        }
        if (blend != newBlend) {
            setBlend(newBlend);
        }
        if (cull != newCull) {
            toggle(GL_CULL_FACE, newCull != Cull.NONE);
            glCullFace(newCull == Cull.FRONT ? GL_FRONT : GL_BACK);
            cull = newCull;
        }
        if (clipDistances != newClipDistances) {
            setClipDistances(newClipDistances);
        }
    }

    private void setClipDistances(int count) {
        for (int i = 0; i < MOST_CLIP_DISTANCES; i++) {
            if (clipDistances < 0 || i < count != i < clipDistances) {
                toggle(GL_CLIP_DISTANCE0 + i, i < count);
            }
        }
        clipDistances = count;
    }

    /** Stays until it is set again, whatever is drawn. */
    public void stencil(Stencil newStencil, int reference) {
        if (stencil == newStencil && (stencilReference == reference || newStencil == Stencil.OFF)) {
            return;
        }
        if (stencil == null || (stencil == Stencil.OFF) != (newStencil == Stencil.OFF)) {
            toggle(GL_STENCIL_TEST, newStencil != Stencil.OFF);
        }
        if (newStencil != Stencil.OFF) {
            glStencilFunc(GL_EQUAL, reference, 0xff);
            glStencilOp(GL_KEEP, GL_KEEP, newStencil.whereDrawn);
        }
        stencil = newStencil;
        stencilReference = reference;
    }

    /** Stays until it is set again. */
    public void depthOf(DepthOf newDepthOf) {
        if (depthOf == newDepthOf) {
            return;
        }
        toggle(GL_DEPTH_CLAMP, newDepthOf != DepthOf.SURFACE);
        boolean isOpening = newDepthOf == DepthOf.OPENING || newDepthOf == DepthOf.WHOLE_FACE;
        toggle(GL_POLYGON_OFFSET_FILL, isOpening);
        if (isOpening) {
            // One pixel's slope and four steps of the buffer: more than two rasterisations of one plane differ by.
            // Along a whole face that slope would reach before its frame; corners lie on the grid to 1/256 pixel.
            glPolygonOffset(newDepthOf == DepthOf.OPENING ? -1 : -1f / 32, -4);
        }
        glDepthRange(newDepthOf == DepthOf.FARTHEST ? 1 : 0, 1);
        depthOf = newDepthOf;
    }

    /** Stays until it is set again. */
    public void fill(Fill newFill) {
        if (fill != newFill) {
            glPolygonMode(GL_FRONT_AND_BACK, newFill.mode);
            fill = newFill;
        }
    }

    /** Stays until it is set again. */
    public void frontFace(FrontFace newFrontFace) {
        if (frontFace != newFrontFace) {
            glFrontFace(newFrontFace.mode);
            frontFace = newFrontFace;
        }
    }

    /** Nothing outside of these pixels is drawn, cleared or copied to until {@link #noScissor}. */
    public void scissor(int x, int y, int width, int height) {
        scissor.keepTo(x, y, width, height);
    }

    public void noScissor() {
        scissor.off();
    }

    private void setDepth(Depth newDepth) {
        toggle(GL_DEPTH_TEST, newDepth != Depth.OFF);
        glDepthMask(newDepth.depthWritten);
        boolean colour = newDepth.colourWritten;
        glColorMask(colour, colour, colour, colour);
        glDepthFunc(newDepth.function);
        depth = newDepth;
    }

    private void setBlend(Blend newBlend) {
        toggle(GL_BLEND, newBlend != Blend.REPLACE);
        switch (newBlend) {
            case REPLACE -> {}
            case OVER -> glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
            case ADD -> glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
            case PREMULTIPLIED_OVER -> glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
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

    Bindings bindings() {
        return bindings;
    }

    /** A clear obeys the depth mask: call before clearing depth. */
    void allowDepthClear() {
        if (depth != Depth.LESS_AND_WRITE) {
            setDepth(Depth.LESS_AND_WRITE);
        }
    }

    /** Call when foreign code (another toolkit, the bare twin) has used the context. */
    public void assumeNothing() {
        bindings.assumeNothing();
        scissor.assumeNothing();
        depth = null;
        blend = null;
        cull = null;
        clipDistances = -1;
        stencil = null;
        depthOf = null;
        fill = null;
        frontFace = null;
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
