package nephele.workshop.art.sprite;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.workshop.art.picture.PictureRecipe;

/** The recipes of the pictures that clouds of levels name; coverage maps and densities repeat with the picture. */
public final class CloudPictures {
    public static final List<PictureRecipe> ALL = List.of(
            new PictureRecipe("textures/clouds/streaks.png", () -> grey(512, CirrusPainter::coverage)),
            new PictureRecipe("textures/clouds/ripples.png", () -> grey(512, RipplePainter::density)),
            new PictureRecipe("textures/clouds/painted.png", PaintedCloud::paint));

    private CloudPictures() {}

    /** A value of 0 to 1 at a place of the picture, which runs from 0 to 1 in both directions from the upper left. */
    interface Tone {
        double at(double x, double y);
    }

    private static BufferedImage grey(int side, Tone tone) {
        var picture = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_GRAY);
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double value = tone.at((column + 0.5) / side, (row + 0.5) / side);
                picture.getRaster().setSample(column, row, 0, code(value));
            }
        }
        return picture;
    }

    static int code(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }
}
