package nephele.editor.paint;

/**
 * A place in a repeated picture, in repeats.
 *
 * @param u to the picture's right, 0 at its left edge
 * @param v downwards, 0 at its top edge
 */
public record TextureCoordinates(double u, double v) {}
