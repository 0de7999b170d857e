package nephele.host.compare;

/**
 * The frame times of two techniques and the difference of their pictures.
 *
 * @param leftMillis median wall time of the last frames until OpenGL has finished, for the left technique;
 *     the first one is not counted, and 0 is told before the second
 * @param rightMillis likewise for the right one
 * @param difference of {@link TechniquePair#tried} from {@link TechniquePair#reference}; {@code null} before the first
 */
public record ComparisonFigures(double leftMillis, double rightMillis, PictureDifference difference) {}
