package nephele.lab.art.terrain;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferUShort;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;

/** Writes heights as a grey PNG of 16 bits. */
public final class TerrainFile {
    private static final int FULL_SCALE = 65535;

    private TerrainFile() {}

    /**
     * Returns the file of square heights.
     *
     * @param heights 0 to 1, row by row
     */
    public static byte[] png(float[] heights, int side) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_USHORT_GRAY);
        short[] values = ((DataBufferUShort) image.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) Math.round(FULL_SCALE * Math.max(0, Math.min(1, heights[i])));
        }
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            ImageIO.write(image, "png", bytes);
            return bytes.toByteArray();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }
}
