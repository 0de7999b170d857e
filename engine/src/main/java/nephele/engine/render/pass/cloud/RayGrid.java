package nephele.engine.render.pass.cloud;

/** Rays through clouds that are drawn at the pixels of a target of their own, as if there were no surfaces. */
interface RayGrid {
    /** Sets the rays of a program in use. */
    void put(PixelUniforms.Rays rays);

    /** Returns the size of a drawn pixel as a share of half the view's height. */
    double pixel();

    /** Returns the time of the rays that were drawn before; the present one if there are none. */
    double secondsBefore();
}
