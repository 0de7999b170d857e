package nephele.editor.proving;

import java.awt.image.BufferedImage;
import nephele.host.compare.ComparisonFigures;
import nephele.host.compare.TechniquePair;

/**
 * The pictures of two techniques.
 *
 * @param left {@code null} if they could not be drawn, as {@code right} and {@code figures} then are
 * @param failure the reason; {@code null} without one
 */
public record ComparedPictures(
        TechniquePair techniques, BufferedImage left, BufferedImage right, ComparisonFigures figures, String failure) {
    static ComparedPictures failed(TechniquePair techniques, String reason) {
        return new ComparedPictures(techniques, null, null, null, reason);
    }
}
