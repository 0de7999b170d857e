package nephele.host.playthrough;

/** How much the picture moves by itself. */
public enum PictureMotion {
    /** The gun sways, the camera dips at landings, and the picture fades after a fall. */
    FULL,
    /** None of that, for people whom it makes unwell. */
    REDUCED
}
