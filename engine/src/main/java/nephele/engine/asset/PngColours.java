package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.joml.Matrix3d;
import org.joml.Vector3d;

/**
 * The chunks of a PNG file that say what colours its numbers are (PNG, third edition, 11.3.2), in their order of
 * precedence: cICP, iCCP, sRGB, and gAMA with cHRM. A picture without any is sRGB.
 *
 * @param profile {@code null} without one
 * @param gamma the power by which light became numbers; 0 if it is not said
 * @param chromaticities of white, red, green and blue; {@code null} if they are not said
 */
record PngColours(byte[] profile, double gamma, double[] chromaticities) {
    static final PngColours SRGB = new PngColours(null, 0, null);

    private static final int ICCP = 0x69434350;
    private static final int SRGB_CHUNK = 0x73524742;
    private static final int GAMA = 0x67414d41;
    private static final int CHRM = 0x6348524d;
    private static final int CICP = 0x63494350;
    private static final int MOST_PROFILE_BYTES = 1 << 20;

    /** The power that stands for sRGB's curve, and how much another may differ. */
    private static final double SRGB_GAMMA = 1 / 2.2;

    private static final double SAME_GAMMA = 0.02;
    private static final double SAME_CHROMATICITY = 0.005;
    private static final double[] SRGB_CHROMATICITIES = {.3127, .329, .64, .33, .3, .6, .15, .06};

    /** Returns the colours of a file whose chunks are known to be whole. */
    static PngColours of(ByteBuffer file, int firstChunk) throws PictureDecoder.UnreadablePicture {
        byte[] profile = null;
        boolean isSrgb = false;
        double gamma = 0;
        double[] chromaticities = null;
        for (int at = firstChunk; at + 12 <= file.limit(); at += file.getInt(at) + 12) {
            int length = file.getInt(at);
            switch (file.getInt(at + 4)) {
                case ICCP -> profile = inflated(file, at + 8, length);
                case SRGB_CHUNK -> isSrgb = true;
                case GAMA -> gamma = length == 4 ? file.getInt(at + 8) / 1e5 : 0;
                case CHRM -> chromaticities = length == 32 ? numbers(file, at + 8) : null;
                case CICP -> {
                    requireSrgb(file, at + 8, length);
                    return SRGB;
                }
                default -> {}
            }
        }
        if (profile != null) {
            return new PngColours(profile, 0, null);
        }
        return isSrgb ? SRGB : new PngColours(null, gamma, chromaticities);
    }

    /** Refuses colours of a wide or a high dynamic range, coded as ITU-T H.273 says. */
    private static void requireSrgb(ByteBuffer file, int at, int length) throws PictureDecoder.UnreadablePicture {
        int primaries = length == 4 ? file.get(at) : 0;
        int curve = length == 4 ? file.get(at + 1) : 0;
        if (primaries != 1 || curve != 13 && curve != 1) {
            throw new PictureDecoder.UnreadablePicture(
                    "has colours of a wide or a high dynamic range (cICP " + primaries + ", " + curve + ")",
                    "save it again in sRGB");
        }
    }

    /** Returns the profile after its name; {@code null} if it is damaged or larger than any display needs. */
    private static byte[] inflated(ByteBuffer file, int start, int length) {
        int end = start;
        while (end < start + length && file.get(end) != 0) {
            end++;
        }
        int content = start + length - end - 2;
        if (content <= 0) {
            return null;
        }
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(file.array(), end + 2, content);
            byte[] profile = new byte[MOST_PROFILE_BYTES];
            int size = inflater.inflate(profile);
            return inflater.finished() ? java.util.Arrays.copyOf(profile, size) : null;
        } catch (DataFormatException damaged) {
            return null;
        } finally {
            inflater.end();
        }
    }

    private static double[] numbers(ByteBuffer file, int at) {
        double[] numbers = new double[8];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = file.getInt(at + 4 * i) / 1e5;
        }
        return numbers;
    }

    /** Returns a picture of these colours in sRGB; itself if it is. */
    Picture toSrgb(Picture stored) {
        if (profile != null) {
            return ColourProfile.toSrgb(stored, profile);
        }
        // A power outside of these limits is a mistake of the program that wrote it.
        boolean isPower = gamma >= 0.1 && gamma <= 2.5;
        Matrix3d matrix = isPower && stored.channels() >= 3 ? matrix() : null;
        if (!isPower || matrix == null && Math.abs(gamma - SRGB_GAMMA) < SAME_GAMMA) {
            return stored;
        }
        return converted(stored, matrix == null ? new Matrix3d() : matrix);
    }

    /** Returns sRGB's light from the file's; {@code null} if they are the same, or nothing usable is said. */
    private Matrix3d matrix() {
        boolean isSame = true;
        for (int i = 0; i < 8 && chromaticities != null; i++) {
            isSame &= Math.abs(chromaticities[i] - SRGB_CHROMATICITIES[i]) < SAME_CHROMATICITY;
        }
        if (isSame) {
            return null;
        }
        Matrix3d matrix = xyz(SRGB_CHROMATICITIES).invert().mul(xyz(chromaticities));
        // Whites are taken for each other: a picture's white is the screen's.
        Vector3d white = matrix.transform(new Vector3d(1, 1, 1));
        matrix = new Matrix3d().scaling(1 / white.x, 1 / white.y, 1 / white.z).mul(matrix);
        return matrix.isFinite() ? matrix : null;
    }

    /** Returns CIE XYZ from the light of primaries whose sum is the white. */
    private static Matrix3d xyz(double[] c) {
        Matrix3d primaries = new Matrix3d(xyz(c[2], c[3]), xyz(c[4], c[5]), xyz(c[6], c[7]));
        Vector3d amounts = primaries.invert(new Matrix3d()).transform(xyz(c[0], c[1]));
        return primaries.scale(amounts.x, amounts.y, amounts.z);
    }

    private static Vector3d xyz(double x, double y) {
        return new Vector3d(x / y, 1, (1 - x - y) / y);
    }

    private Picture converted(Picture stored, Matrix3d matrix) {
        int full = stored.bitsPerChannel() == 8 ? 255 : 65_535;
        double[] light = new double[full + 1];
        for (int i = 0; i <= full; i++) {
            light[i] = StrictMath.pow(i / (double) full, 1 / gamma);
        }
        byte[] samples = stored.samples().clone();
        int colours = stored.channels() < 3 ? 1 : 3;
        Vector3d pixel = new Vector3d();
        for (int y = 0; y < stored.height(); y++) {
            for (int x = 0; x < stored.width(); x++) {
                for (int i = 0; i < 3; i++) {
                    pixel.setComponent(i, light[stored.sample(x, y, Math.min(i, colours - 1))]);
                }
                matrix.transform(pixel);
                for (int i = 0; i < colours; i++) {
                    int value = (int) Math.rint(full * encoded(pixel.get(i)));
                    int at = (y * stored.width() + x) * stored.channels() + i;
                    if (full == 255) {
                        samples[at] = (byte) value;
                    } else {
                        samples[2 * at] = (byte) value;
                        samples[2 * at + 1] = (byte) (value >> 8);
                    }
                }
            }
        }
        return new Picture(stored.width(), stored.height(), stored.channels(), stored.bitsPerChannel(), samples);
    }

    /** Returns light by sRGB's curve (IEC 61966-2-1). */
    private static double encoded(double linear) {
        double light = Math.min(1, Math.max(0, linear));
        return light <= 0.0031308 ? 12.92 * light : 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055;
    }
}
