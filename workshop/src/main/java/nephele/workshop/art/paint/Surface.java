package nephele.workshop.art.paint;

import java.awt.image.BufferedImage;

/** A square of painted material: colour, height and roughness of every texel. It tiles, so neighbours wrap. */
public final class Surface {
    public static final int SIDE_TEXELS = 512;

    private final double metres;
    private final Texel[] texels = new Texel[SIDE_TEXELS * SIDE_TEXELS];

    public Surface(double metres) {
        this.metres = metres;
        for (int i = 0; i < texels.length; i++) {
            texels[i] = new Texel();
        }
    }

    /** A texel. */
    public static final class Texel {
        public PaintColour colour = PaintColour.CONCRETE;
        /** Height in metres. */
        public double height;
        /** Factor on the material's roughness, 0–1. */
        public double roughness = 1;

        public void blend(PaintColour over, double fraction) {
            colour = colour.mix(over, fraction);
        }

        public void shade(double factor) {
            colour = colour.times(factor);
        }
    }

    /** Paints one texel; x to the right and y upwards from the lower left corner, in metres. */
    public interface Brush {
        void paint(double x, double y, Texel texel);
    }

    public double metres() {
        return metres;
    }

    /** Returns the width of a texel in metres. */
    public double texelMetres() {
        return metres / SIDE_TEXELS;
    }

    public void each(Brush brush) {
        for (int row = 0; row < SIDE_TEXELS; row++) {
            double y = (SIDE_TEXELS - row - 0.5) * texelMetres();
            for (int column = 0; column < SIDE_TEXELS; column++) {
                brush.paint((column + 0.5) * texelMetres(), y, texels[row * SIDE_TEXELS + column]);
            }
        }
    }

    /** Returns the texel at any point; the tile repeats. */
    public Texel at(double x, double y) {
        int column = Math.floorMod((int) Math.floor(x / texelMetres()), SIDE_TEXELS);
        int row = Math.floorMod(SIDE_TEXELS - 1 - (int) Math.floor(y / texelMetres()), SIDE_TEXELS);
        return texels[row * SIDE_TEXELS + column];
    }

    public BufferedImage colourPicture() {
        return Pixels.picture(
                SIDE_TEXELS, SIDE_TEXELS, (column, row) -> texels[row * SIDE_TEXELS + column].colour.rgb());
    }

    /** Returns tangent-space normals, red to the right and green upwards, with the roughness factor in alpha. */
    public BufferedImage normalPicture() {
        BufferedImage picture = new BufferedImage(SIDE_TEXELS, SIDE_TEXELS, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < texels.length; i++) {
            picture.setRGB(i % SIDE_TEXELS, i / SIDE_TEXELS, normalCode(i % SIDE_TEXELS, i / SIDE_TEXELS));
        }
        return picture;
    }

    private int normalCode(int column, int row) {
        double slopeX = (height(column + 1, row) - height(column - 1, row)) / (2 * texelMetres());
        double slopeY = (height(column, row - 1) - height(column, row + 1)) / (2 * texelMetres());
        double length = Math.sqrt(slopeX * slopeX + slopeY * slopeY + 1);
        PaintColour code = new PaintColour(0.5 - slopeX / length / 2, 0.5 - slopeY / length / 2, 0.5 + 0.5 / length);
        return PaintColour.code(texels[row * SIDE_TEXELS + column].roughness) << 24 | code.rgb();
    }

    private double height(int column, int row) {
        return texels[Math.floorMod(row, SIDE_TEXELS) * SIDE_TEXELS + Math.floorMod(column, SIDE_TEXELS)].height;
    }
}
