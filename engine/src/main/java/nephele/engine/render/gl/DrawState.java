package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

/**
 * The fixed-function state and, in {@link Bindings}, the bound objects; calls OpenGL only for differences. Also counts
 * the submissions of a frame.
 */
public final class DrawState {
    /** Depth test and write, and whether colour is written. */
    public enum Depth {
        OFF(GL_LESS, false, true),
        LESS_AND_WRITE(GL_LESS, true, true),
        /** Writes depth for later passes and leaves the colour unchanged. */
        LESS_AND_WRITE_ONLY_DEPTH(GL_LESS, true, false),
        /** Passes at equal depth and writes no depth; for surfaces at the far plane. */
        LESS_OR_EQUAL(GL_LEQUAL, false, true),
        /** Passes where a surface is nearer; at the far plane that is every pixel with a surface. */
        GREATER(GL_GREATER, false, true),
        /** Passes if this very surface is the nearest. */
        EQUAL(GL_EQUAL, false, true),
        /** Passes as {@link #EQUAL} does, but depth and colour stay unchanged; only the stencil is written. */
        EQUAL_ONLY_STENCIL(GL_EQUAL, false, false),
        ALWAYS_AND_WRITE(GL_ALWAYS, true, true),
        ALWAYS_AND_WRITE_ONLY_DEPTH(GL_ALWAYS, true, false),
        /** Depth and colour stay unchanged; only the stencil is written. */
        ALWAYS_ONLY_STENCIL(GL_ALWAYS, false, false);

        private final int function;
        private final boolean depthWritten;
        private final boolean colourWritten;

        Depth(int function, boolean depthWritten, boolean colourWritten) {
            this.function = function;
            this.depthWritten = depthWritten;
            this.colourWritten = colourWritten;
        }
    }

    /** The stencil test and operation. */
    public enum Stencil {
        /** All pixels pass; the stencil stays. */
        OFF(GL_KEEP),
        /** Pixels that hold the reference pass. */
        EQUAL(GL_KEEP),
        /** Pixels that hold the reference pass; the value is incremented where depth passes too. */
        EQUAL_COUNT_UP(GL_INCR),
        /** Pixels that hold the reference pass; the value is decremented where depth passes too. */
        EQUAL_COUNT_DOWN(GL_DECR);

        private final int whereDrawn;

        Stencil(int whereDrawn) {
            this.whereDrawn = whereDrawn;
        }
    }

    /** The source of a polygon's depth. */
    public enum DepthOf {
        SURFACE,
        /**
         * The depth of an opening in a wall: in front of the wall by the least resolvable step, never clipped by near
         * and far.
         */
        OPENING,
        /**
         * Like {@link #OPENING}, for a whole face: in front of it by the error from snapping the corners of both to the
         * pixel grid.
         */
        WHOLE_FACE,
        /** The greatest depth, independent of position. */
        FARTHEST
    }

    /** The blending of a fragment with the target. */
    public enum Blend {
        REPLACE,
        /** As {@link #REPLACE}, in as many of a pixel's samples as alpha says; alpha becomes 1. */
        REPLACE_COVERED_SAMPLES,
        /** Source alpha over destination; the destination keeps its alpha. */
        OVER,
        /** Adds source to destination; the destination keeps its alpha. */
        ADD,
        /**
         * As {@link #OVER}, and reduces the destination's alpha by as much as its colour: alpha is then the share of a
         * linear picture's pixel that is metered for exposure.
         */
        OVER_UNMETERED,
        /** As {@link #ADD}, and reduces the destination's alpha by the source's. */
        ADD_UNMETERED,
        /** Source with premultiplied alpha over destination, which keeps its alpha. */
        COVER,
        /** As {@link #COVER}, alpha included; for layers that are composited later. */
        PREMULTIPLIED_OVER,
        /** As {@link #PREMULTIPLIED_OVER}, but the destination's alpha is the share of light that passes, at first 1. */
        PREMULTIPLIED_OVER_PASSING
    }

    /** The culled faces. */
    public enum Cull {
        NONE,
        BACK,
        /** Culls like {@link #BACK} in a mirrored view. */
        FRONT
    }

    /** The winding of a triangle that faces the eye. */
    public enum FrontFace {
        COUNTER_CLOCKWISE(GL_CCW),
        /** For a mirrored view. */
        CLOCKWISE(GL_CW);

        private final int mode;

        FrontFace(int mode) {
            this.mode = mode;
        }
    }

    /** The drawn part of a triangle. */
    public enum Fill {
        WHOLE(GL_FILL),
        /** Its three edges, a pixel wide; face culling is unchanged. */
        EDGES(GL_LINE);

        private final int mode;

        Fill(int mode) {
            this.mode = mode;
        }
    }

    /** Number of clip distances: one for the view's plane and two for a dynamic object at a portal. */
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

    /** Sets depth, blending and culling, without clip distances. */
    public void set(Depth newDepth, Blend newBlend, Cull newCull) {
        set(newDepth, newBlend, newCull, 0);
    }

    /**
     * Sets depth, blending, culling and clip distances.
     *
     * @param newClipDistances the number of elements of {@code gl_ClipDistance} that clip, from the first on
     */
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

    /** Sets the stencil; stays until the next call. */
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
        // llvmpipe tests before a shader that discards only if the stencil stays. A clear obeys the mask.
        glStencilMask(newStencil == Stencil.EQUAL ? 0 : 0xff);
        stencil = newStencil;
        stencilReference = reference;
    }

    /** Sets the source of depth; stays until the next call. */
    public void depthOf(DepthOf newDepthOf) {
        if (depthOf == newDepthOf) {
            return;
        }
        toggle(GL_DEPTH_CLAMP, newDepthOf != DepthOf.SURFACE);
        boolean isOpening = newDepthOf == DepthOf.OPENING || newDepthOf == DepthOf.WHOLE_FACE;
        toggle(GL_POLYGON_OFFSET_FILL, isOpening);
        if (isOpening) {
            // One pixel's slope and four steps of the buffer exceed the difference of any two rasterisations of one
            // plane. Along a whole face, that slope would reach in front of its frame; corners are on the grid to 1/256
            // pixel.
            glPolygonOffset(newDepthOf == DepthOf.OPENING ? -1 : -1f / 32, -4);
        }
        glDepthRange(newDepthOf == DepthOf.FARTHEST ? 1 : 0, 1);
        depthOf = newDepthOf;
    }

    /** Sets the fill mode; stays until the next call. */
    public void fill(Fill newFill) {
        if (fill != newFill) {
            glPolygonMode(GL_FRONT_AND_BACK, newFill.mode);
            fill = newFill;
        }
    }

    /** Sets the winding; stays until the next call. */
    public void frontFace(FrontFace newFrontFace) {
        if (frontFace != newFrontFace) {
            glFrontFace(newFrontFace.mode);
            frontFace = newFrontFace;
        }
    }

    /** Limits drawing, clearing and copying to these pixels until {@link #noScissor}. */
    public void scissor(int x, int y, int width, int height) {
        scissor.keepTo(x, y, width, height);
    }

    public void noScissor() {
        scissor.off();
    }

    /**
     * The limits of drawing in a view, kept while a layer of fewer pixels is drawn. One object can serve all frames.
     */
    public static final class Limits {
        private Stencil stencil;
        private int reference;
        private Scissor scissor;
    }

    /**
     * Begins a layer of a view that has a target of its own: no stencil, the scissor divided.
     *
     * @param before receives what {@link #endLayer} restores
     */
    public void beginLayer(int divisor, Limits before) {
        before.stencil = stencil;
        before.reference = stencilReference;
        before.scissor = scissor.copy();
        stencil(Stencil.OFF, 0);
        scissor.divide(divisor);
    }

    /** Ends a layer. */
    public void endLayer(Limits before) {
        stencil(before.stencil, before.reference);
        scissor.restore(before.scissor);
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
        boolean areSamplesChosen = newBlend == Blend.REPLACE_COVERED_SAMPLES;
        toggle(GL_BLEND, newBlend != Blend.REPLACE && !areSamplesChosen);
        if (areSamplesChosen || blend == Blend.REPLACE_COVERED_SAMPLES) {
            toggle(GL_SAMPLE_ALPHA_TO_COVERAGE, areSamplesChosen);
            toggle(GL_SAMPLE_ALPHA_TO_ONE, areSamplesChosen);
        }
        switch (newBlend) {
            case REPLACE, REPLACE_COVERED_SAMPLES -> {}
            case OVER -> glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
            case ADD -> glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
            case OVER_UNMETERED ->
                glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
            case ADD_UNMETERED -> glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
            case COVER -> glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
            case PREMULTIPLIED_OVER -> glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            case PREMULTIPLIED_OVER_PASSING ->
                glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
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

    /** Enables the depth mask, which a clear of depth obeys; call before such a clear. */
    void allowDepthClear() {
        if (depth != Depth.LESS_AND_WRITE) {
            setDepth(Depth.LESS_AND_WRITE);
        }
    }

    /** Discards the cached state; call after foreign code (another toolkit, the bare twin) has used the context. */
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

    /** Sets the listener; {@code null} to stop. */
    void listen(DrawListener newListener) {
        listener = newListener;
    }

    /** Returns {@code null} outside of recordings. */
    DrawListener listener() {
        return listener;
    }

    void drawn(int calls, long drawnTriangles) {
        draws += calls;
        triangles += drawnTriangles;
    }

    /** Returns the number of draw calls since {@link #resetCounts}; one multi-draw counts as one. */
    public long draws() {
        return draws;
    }

    /** Returns the number of triangles submitted since {@link #resetCounts}. */
    public long triangles() {
        return triangles;
    }

    /** Sets the counts of draw calls and triangles to 0. */
    public void resetCounts() {
        draws = 0;
        triangles = 0;
    }
}
