package nephele.engine.render.pass.overlay;

import java.util.Arrays;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.DisplayColour;

/**
 * The overlay of a picture, as quads. Lengths are points from the upper left corner; a point is one pixel at scale 1
 * and two at scale 2. Fill it only when the content changes, because the pass then uploads it.
 */
public final class OverlayCanvas {
    /** x, y in pixels, u, v in atlas texels, red, green, blue, alpha. */
    static final int FLOATS_PER_VERTEX = 8;

    static final int VERTICES_PER_QUAD = 4;

    /** The colour of a picture's corners: the shader samples the picture where alpha is negative. */
    private static final DisplayColour PICTURE = new DisplayColour(1, 1, 1, -1);

    private final FontAtlas letters;
    private float[] vertices = new float[64 * VERTICES_PER_QUAD * FLOATS_PER_VERTEX];
    private int length;
    private double scale = 1;
    private long version;
    private Picture picture;

    /** Creates an empty canvas. */
    public OverlayCanvas(FontAtlas letters) {
        this.letters = letters;
    }

    /** Empties the canvas. */
    public void begin(double pixelsPerPoint) {
        length = 0;
        picture = null;
        scale = pixelsPerPoint;
        version++;
    }

    public boolean isEmpty() {
        return length == 0;
    }

    /** Adds a filled rectangle. */
    public void rectangle(double x, double y, double width, double height, DisplayColour colour) {
        double solid = FontAtlas.SOLID_TEXELS / 2.0;
        corner(x * scale, y * scale, solid, solid, colour);
        corner((x + width) * scale, y * scale, solid, solid, colour);
        corner((x + width) * scale, (y + height) * scale, solid, solid, colour);
        corner(x * scale, (y + height) * scale, solid, solid, colour);
    }

    /** Adds a picture of display-referred colours; a canvas has one at most. */
    public void picture(double x, double y, double width, double height, Picture newPicture) {
        picture = newPicture;
        corner(x * scale, y * scale, 0, 0, PICTURE);
        corner((x + width) * scale, y * scale, newPicture.width(), 0, PICTURE);
        corner((x + width) * scale, (y + height) * scale, newPicture.width(), newPicture.height(), PICTURE);
        corner(x * scale, (y + height) * scale, 0, newPicture.height(), PICTURE);
    }

    /** Returns the canvas's picture; {@code null} for none. */
    Picture picture() {
        return picture;
    }

    /**
     * Adds one line of text; its baseline is rounded to a whole pixel, which keeps it sharp.
     *
     * @param em size of the letters in points; capitals are 0.7 em high
     * @return x of the next letter
     */
    public double text(double x, double baseline, double em, DisplayColour colour, String line) {
        double texelPixels = em * scale / FontAtlas.TEXELS_PER_EM;
        double pen = x * scale;
        double baselinePixels = Math.rint(baseline * scale);
        for (int i = 0; i < line.length(); i += Character.charCount(line.codePointAt(i))) {
            int codePoint = line.codePointAt(i);
            if (codePoint != ' ') {
                letter(letters.cell(codePoint), new double[] {pen, baselinePixels, texelPixels}, colour);
            }
            pen += letters.advanceEm(codePoint) * em * scale;
        }
        return pen / scale;
    }

    /** Returns the width of a line of text in points. */
    public double width(double em, String line) {
        return line.codePoints().mapToDouble(letters::advanceEm).sum() * em;
    }

    float[] vertices() {
        return vertices;
    }

    int length() {
        return length;
    }

    int quads() {
        return length / (FLOATS_PER_VERTEX * VERTICES_PER_QUAD);
    }

    /** Returns a number that rises with every {@link #begin}. */
    long version() {
        return version;
    }

    private void letter(FontAtlas.Cell cell, double[] penBaselineTexel, DisplayColour colour) {
        double texel = penBaselineTexel[2];
        double left = penBaselineTexel[0] - FontAtlas.originTexels() * texel;
        double bottom = penBaselineTexel[1] + FontAtlas.baselineTexels() * texel;
        double right = left + cell.width() * texel;
        double top = bottom - cell.height() * texel;
        corner(left, top, cell.x(), cell.y() + cell.height(), colour);
        corner(right, top, cell.x() + cell.width(), cell.y() + cell.height(), colour);
        corner(right, bottom, cell.x() + cell.width(), cell.y(), colour);
        corner(left, bottom, cell.x(), cell.y(), colour);
    }

    private void corner(double x, double y, double u, double v, DisplayColour colour) {
        if (length == vertices.length) {
            vertices = Arrays.copyOf(vertices, 2 * length);
        }
        vertices[length] = (float) x;
        vertices[length + 1] = (float) y;
        vertices[length + 2] = (float) u;
        vertices[length + 3] = (float) v;
        vertices[length + 4] = colour.red();
        vertices[length + 5] = colour.green();
        vertices[length + 6] = colour.blue();
        vertices[length + 7] = colour.alpha();
        length += FLOATS_PER_VERTEX;
    }
}
