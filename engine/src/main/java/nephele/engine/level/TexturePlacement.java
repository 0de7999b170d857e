package nephele.engine.level;

/**
 * A change of where the picture of a face's material lies: the picture is scaled, then turned, then shifted. With
 * {@link TextureMapping#WORLD} it is scaled and turned about the world's origin, with {@link TextureMapping#FACE} about
 * the middle of the face. Right and up are as seen from outside, on floors and ceilings +x and −z or +z.
 *
 * @param shiftUMetres to the right
 * @param shiftVMetres upwards
 * @param rotationDegrees counter-clockwise as seen from outside
 * @param scaleU factor on the picture's width; a negative one mirrors it
 * @param scaleV factor on its height
 */
public record TexturePlacement(
        @Written @Range double shiftUMetres,
        @Written @Range double shiftVMetres,
        @Written @Range(min = -360, max = 360) double rotationDegrees,
        @Written(absent = "1") @Range(min = LEAST_SCALE, max = 1e4, shape = Range.Shape.EITHER_SIGN) double scaleU,
        @Written(absent = "1") @Range(min = LEAST_SCALE, max = 1e4, shape = Range.Shape.EITHER_SIGN) double scaleV) {
    /** The placement that changes nothing. */
    public static final TexturePlacement NONE = new TexturePlacement(0, 0, 0, 1, 1);

    /** The least absolute value of a scale. */
    public static final double LEAST_SCALE = 1e-3;

    /** Returns true if the picture's right is not the face's right, or its up not the face's up. */
    public boolean isTurned() {
        return rotationDegrees % 360 != 0 || scaleU < 0 || scaleV < 0;
    }
}
