package nephele.engine.render.pass.cloud;

/** Which pixels a program for clouds draws, and what of a cloud. */
public enum CloudPixels {
    /** All, as far as surfaces let them see. */
    ALL,
    /** All of a layer, as if there were no surfaces. */
    WHOLE,
    /** All of a layer, a block of the view's pixels each: what is in front of the nearest surface of the block and around it. */
    BEFORE_NEAREST,
    /** As {@link #BEFORE_NEAREST}, of the farthest surface. */
    BEFORE_FARTHEST,
    /** All that the stencil passes, in front of their own surfaces. */
    BEFORE_OWN,
    /** All of a layer, as {@link #WHOLE}: the light of a flash of lightning in the cloud. */
    FLASH,
    /** One for each point of a bolt: what the cloud hides of it. */
    BOLT,
    /** All of a picture that is kept: as if there were no surfaces, air, fog and mirrors. */
    BAKED,
    /** All of an impostor's picture, as if there were neither surfaces nor air. */
    CAPTURED;

    /** Returns true if rays belong to a {@link CloudCanvas.Grid}. */
    boolean isGrid() {
        return isBeforeSurfaces() || this == WHOLE || this == FLASH || this == CAPTURED;
    }

    /** Returns true if they are drawn for {@link SurfaceClouds}. */
    boolean isBeforeSurfaces() {
        return this == BEFORE_NEAREST || this == BEFORE_FARTHEST || this == BEFORE_OWN;
    }

    /** Returns true if the cloud is drawn as it looks without a flash. */
    public boolean isLook() {
        return this != FLASH && this != BOLT;
    }

    /** Returns true if another technique may draw a part of the cloud's optical depth. */
    boolean isShared() {
        return isBeforeSurfaces() || this == ALL || this == WHOLE;
    }
}
