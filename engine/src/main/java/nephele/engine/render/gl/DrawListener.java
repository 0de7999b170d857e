package nephele.engine.render.gl;

/** Hears of everything that is submitted, for recording; see {@link BareFrame}. */
interface DrawListener {
    /** The bound framebuffer is about to be cleared; {@code colour} is {@code null} when only depth is. */
    void cleared(float[] colour);

    /** Indexed triangles are about to be drawn with what is bound. */
    void drawn(int[] firsts, int[] counts);

    /** The full-screen triangle is about to be drawn with what is bound. */
    void drawnFullScreen();
}
