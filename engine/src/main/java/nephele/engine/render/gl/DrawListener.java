package nephele.engine.render.gl;

/** Hears of everything that is submitted, for recording; see {@link BareFrame}. */
interface DrawListener {
    /** The bound framebuffer is about to be cleared; {@code colour} is {@code null} when only depth is. */
    void cleared(float[] colour);

    /** Indexed triangles are about to be drawn with what is bound. */
    void drawn(int[] firsts, int[] counts);

    /** The content of a buffer of vertices has been replaced. */
    void uploaded(int buffer, float[] values);

    /** Triangles without indices are about to be drawn with what is bound. */
    void drawnUnindexed(int first, int count);

    /** Lines are about to be drawn with what is bound, two vertices each. */
    void drawnLines(int count);

    /** Indexed triangles are about to be drawn several times over with what is bound. */
    void drawnInstanced(int first, int count, int instances);

    /** The full-screen triangle is about to be drawn with what is bound. */
    void drawnFullScreen();

    /** Pixels of framebuffer {@code from} are about to be copied to the bound one, of the same size. */
    void copied(int from, int to, int width, int height, CopiedPlanes copied);
}
