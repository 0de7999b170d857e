package nephele.lab.art;

import java.awt.image.BufferedImage;

/** A square of painted material: colour, height and roughness of every texel. It tiles, so neighbours wrap. */
final class Surface {
    static final int SIDE = 512;

    private final double metres;
    private final Texel[] texels = new Texel[SIDE * SIDE];

    Surface(double metres) {
        this.metres = metres;
        for (int i = 0; i < texels.length; i++) {
            texels[i] = new Texel();
        }
    }

    /** A texel. */
    static final class Texel {
        Colour colour = Palette.CONCRETE;
        /** Height in metres. */
        double height;
        /** Factor on the material's roughness, 0–1. */
        double roughness = 1;

        void blend(Colour over, double share) {
            colour = colour.mix(over, share);
        }

        void shade(double factor) {
            colour = colour.times(factor);
        }
    }

    /** Paints one texel; x to the right and y upwards from the lower left corner, in metres. */
    interface Brush {
        void paint(double x, double y, Texel texel);
    }

    double metres() {
        return metres;
    }

    /** Returns the width of a texel in metres. */
    double texelMetres() {
        return metres / SIDE;
    }

    void each(Brush brush) {
        for (int row = 0; row < SIDE; row++) {
            double y = (SIDE - row - 0.5) * texelMetres();
            for (int column = 0; column < SIDE; column++) {
                brush.paint((column + 0.5) * texelMetres(), y, texels[row * SIDE + column]);
            }
        }
    }

    /** Returns the texel at any point; the tile repeats. */
    Texel at(double x, double y) {
        int column = Math.floorMod((int) Math.floor(x / texelMetres()), SIDE);
        int row = Math.floorMod(SIDE - 1 - (int) Math.floor(y / texelMetres()), SIDE);
        return texels[row * SIDE + column];
    }

    BufferedImage colourPicture() {
        return Pixels.picture(SIDE, SIDE, (column, row) -> texels[row * SIDE + column].colour.rgb());
    }

    /** Returns tangent-space normals, red to the right and green upwards, with the roughness factor in alpha. */
    BufferedImage normalPicture() {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < texels.length; i++) {
            picture.setRGB(i % SIDE, i / SIDE, normalCode(i % SIDE, i / SIDE));
        }
        return picture;
    }

    private int normalCode(int column, int row) {
        double slopeX = (height(column + 1, row) - height(column - 1, row)) / (2 * texelMetres());
        double slopeY = (height(column, row - 1) - height(column, row + 1)) / (2 * texelMetres());
        double length = Math.sqrt(slopeX * slopeX + slopeY * slopeY + 1);
        Colour code = new Colour(0.5 - slopeX / length / 2, 0.5 - slopeY / length / 2, 0.5 + 0.5 / length);
        return Colour.code(texels[row * SIDE + column].roughness) << 24 | code.rgb();
    }

    private double height(int column, int row) {
        return texels[Math.floorMod(row, SIDE) * SIDE + Math.floorMod(column, SIDE)].height;
    }
}
