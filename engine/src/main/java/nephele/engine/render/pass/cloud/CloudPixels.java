package nephele.engine.render.pass.cloud;

/** Which pixels a program for clouds draws. */
public enum CloudPixels {
    /** All, as far as surfaces let them see. */
    ALL,
    /** All of a layer, as if there were no surfaces. */
    WHOLE,
    /** Those whose surface is among the clouds. */
    MIXED
}
