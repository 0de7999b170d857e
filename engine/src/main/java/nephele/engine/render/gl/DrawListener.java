package nephele.engine.render.gl;

/** Called for every submission, for recordings; see {@link BareFrame}. */
interface DrawListener {
    /** Called before the bound framebuffer is cleared; {@code colour} is {@code null} if only depth is. */
    void cleared(float[] colour);

    /** Called before indexed triangles are drawn with the bound state. */
    void drawn(int[] firsts, int[] counts);

    /** Called after the content of a vertex buffer has been replaced. */
    void uploaded(int buffer, float[] values);

    /** Called before triangles without indices are drawn with the bound state. */
    void drawnUnindexed(int first, int count);

    /** Called before lines are drawn with the bound state, two vertices each. */
    void drawnLines(int count);

    /** Called before points are drawn with the bound state. */
    void drawnPoints(int count);

    /** Called before instanced indexed triangles are drawn with the bound state. */
    void drawnInstanced(int first, int count, int instances);

    /** Called before the full-screen triangle is drawn with the bound state. */
    void drawnFullScreen();

    /** Called before pixels of framebuffer {@code from} are copied to the bound one, of the same size. */
    void copied(int from, int to, int width, int height, CopiedPlanes copied);
}
