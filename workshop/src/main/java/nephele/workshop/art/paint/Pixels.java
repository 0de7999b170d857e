package nephele.workshop.art.paint;

import java.awt.image.BufferedImage;

/** A function from the position of a pixel to its colour. */
@FunctionalInterface
public interface Pixels {
    /** Returns {@code 0xRRGGBB}; rows count from the top. */
    int rgb(int column, int row);

    static BufferedImage picture(int width, int height, Pixels pixels) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                picture.setRGB(column, row, pixels.rgb(column, row));
            }
        }
        return picture;
    }
}
